#include "oracle/orbit.h"

#include "oracle/crossing.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

struct Stop {
    int sphere = -1; // -1: the ray escapes
    QuadVec point{}, normal{};
};

std::vector<QuadShape> shapesOf(std::span<const MirrorSphere> spheres)
{
    std::vector<QuadShape> shapes;
    for (const MirrorSphere& sphere : spheres) {
        const glm::dvec3& c = sphere.centre;
        shapes.push_back(quadShape(shapeSphere, {c.x, c.y, c.z, sphere.radius}));
    }
    return shapes;
}

// The next sphere on the way; one that the ray has just left is convex and cannot be met again at once.
Stop nextStop(std::span<const QuadShape> shapes, const QuadRay& ray, int left)
{
    Stop stop;
    Quad nearest = 0;
    for (int i = 0; i < static_cast<int>(shapes.size()); ++i) {
        const QuadShape& shape = shapes[static_cast<std::size_t>(i)];
        if (i == left)
            continue;
        const QuadHit hit = firstHit(shape, ray, 0, false);
        if (hit.hit && (stop.sphere < 0 || hit.t < nearest)) {
            nearest = hit.t;
            stop = {i, shape.reference + hit.offset, hit.normal};
        }
    }
    return stop;
}

std::vector<Stop> stopsOf(std::span<const QuadShape> shapes, QuadRay ray, int most)
{
    std::vector<Stop> stops;
    int left = -1;
    while (static_cast<int>(stops.size()) < most) {
        const Stop stop = nextStop(shapes, ray, left);
        if (stop.sphere < 0)
            break;
        stops.push_back(stop);
        ray.origin = stop.point;
        ray.direction = ray.direction - 2 * dot(ray.direction, stop.normal) * stop.normal;
        left = stop.sphere;
    }
    return stops;
}

Quad distanceBetween(const QuadVec& a, const QuadVec& b)
{
    const QuadVec apart = a - b;
    return sqrtq(dot(apart, apart));
}

// A unit vector across the direction.
QuadVec sideways(const QuadVec& direction)
{
    const bool alongX =
        magnitude(direction.x) > magnitude(direction.y) && magnitude(direction.x) > magnitude(direction.z);
    return unit(cross(direction, alongX ? QuadVec{0, 1, 0} : QuadVec{1, 0, 0}));
}

} // namespace

std::vector<MirrorSphere> mirrorSpheres(int count, double distance)
{
    const double half = distance / 2.0;
    const double triangleHeight = distance * std::sqrt(3.0) / 2.0;
    const double tetrahedronHeight = distance * std::sqrt(2.0 / 3.0);
    const std::vector<glm::dvec3> corners{{-half, 0.0, 0.0},
                                          {half, 0.0, 0.0},
                                          {0.0, triangleHeight, 0.0},
                                          {0.0, triangleHeight / 3.0, tetrahedronHeight}};
    const auto used = std::span(corners).first(static_cast<std::size_t>(count));
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& corner : used)
        middle += corner / static_cast<double>(count);
    std::vector<MirrorSphere> spheres;
    for (const glm::dvec3& corner : used)
        spheres.push_back({corner - middle, 1.0});
    return spheres;
}

std::vector<OrbitStop> mirrorOrbit(std::span<const MirrorSphere> spheres, const glm::dvec3& origin,
                                   const glm::dvec3& direction, int most)
{
    std::vector<OrbitStop> orbit;
    for (const Stop& stop : stopsOf(shapesOf(spheres), {quadFrom(origin), quadFrom(direction)}, most))
        orbit.push_back({stop.sphere, doubleFrom(stop.point)});
    return orbit;
}

double orbitGrowth_log10(std::span<const MirrorSphere> spheres, const glm::dvec3& origin,
                         const glm::dvec3& direction, int most)
{
    const std::vector<QuadShape> shapes = shapesOf(spheres);
    double largest = 0.0;
    for (const MirrorSphere& sphere : spheres)
        largest = std::max(largest, sphere.radius);
    const QuadRay ray{quadFrom(origin), quadFrom(direction)};
    const Quad shift = static_cast<Quad>(1e-28) * static_cast<Quad>(largest);
    const QuadRay beside{ray.origin + shift * sideways(ray.direction), ray.direction};
    const std::vector<Stop> stops = stopsOf(shapes, ray, most);
    const std::vector<Stop> besides = stopsOf(shapes, beside, most);
    std::vector<Quad> apart;
    const Quad linear =
        static_cast<Quad>(1e-6) * static_cast<Quad>(largest); // beyond it growth is no longer steady
    for (std::size_t i = 0; i < std::min(stops.size(), besides.size()); ++i) {
        apart.push_back(distanceBetween(stops[i].point, besides[i].point));
        if (apart.back() > linear || stops[i].sphere != besides[i].sphere) {
            apart.pop_back();
            break;
        }
    }
    if (apart.size() < 2)
        return 0.0;
    return std::log10(static_cast<double>(apart.back() / apart.front())) /
           static_cast<double>(apart.size() - 1);
}

double twoSphereGrowth_log10(double distance, double radius)
{
    const Quad x =
        (static_cast<Quad>(distance) - 2 * static_cast<Quad>(radius)) / static_cast<Quad>(radius) + 1;
    return static_cast<double>(logq(x + sqrtq(x * x - 1)) / logq(10));
}

} // namespace dioptre
