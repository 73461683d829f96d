#include "render/kernel_choice.h"

#include "scene/direction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dioptre
{
namespace
{

constexpr double mostRounding_px = 0.05;
constexpr double mostBend = 1e4; // radii by the distance to the surface
constexpr double bound = 8.0;    // of plain kernels, in units of rounding
constexpr double mostFine = 1e9; // metres: compensated cylinders take products of four lengths
constexpr int finestLines = 1080;

// Distance of the segment's nearest point; a is the segment's start, seen from the eye.
double distanceToSegment(const glm::dvec3& a, const glm::dvec3& edge)
{
    const double along = std::clamp(-glm::dot(a, edge) / glm::dot(edge, edge), 0.0, 1.0);
    return glm::length(a + along * edge);
}

// Of a polygon whose corners, seen from the eye, run around it in the plane with that normal.
double distanceToPolygon(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal)
{
    double edges = std::numeric_limits<double>::infinity();
    int left = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 edge = corners[(i + 1) % corners.size()] - corners[i];
        left += glm::dot(glm::cross(edge, -corners[i]), normal) >= 0.0 ? 1 : 0;
        edges = std::min(edges, distanceToSegment(corners[i], edge));
    }
    // Where the eye stands above or below the face, that is nearer than any edge.
    const bool above = left == 0 || left == static_cast<int>(corners.size());
    return above ? std::abs(glm::dot(corners.front(), normal)) : edges;
}

// A shape's reference point and size, as glsl/kernel bounds its errors; and how far its surface is away.
struct Measure {
    glm::dvec3 reference;
    double size;
    double distance;
    double radius;  // of a round shape; 0 of a flat one
    double toRound; // how far the round part of its surface is
};

class Measurer
{
public:
    explicit Measurer(const glm::dvec3& eye) : eye_(eye) {}

    Measure operator()(const Sphere& sphere) const
    {
        const double away = glm::length(eye_ - sphere.centre);
        return {sphere.centre, sphere.radius, std::abs(away - sphere.radius), sphere.radius,
                std::abs(away - sphere.radius)};
    }

    Measure operator()(const Cylinder& cylinder) const
    {
        const glm::dvec3 axis = unit(cylinder.axis);
        const double height = glm::dot(cylinder.axis, axis);
        const glm::dvec3 offset = eye_ - cylinder.base;
        const double z = glm::dot(offset, axis);
        const double aside = glm::length(offset - z * axis) - cylinder.radius;
        const double beyond = std::max({-z, z - height, 0.0});
        const double toWall = std::hypot(aside, beyond);
        double distance = toWall;
        if (cylinder.capped) {
            const double toEnds = std::min(std::abs(z), std::abs(height - z));
            distance = std::min(distance, std::hypot(std::max(aside, 0.0), toEnds));
        }
        return {cylinder.base, cylinder.radius + height, distance, cylinder.radius, toWall};
    }

    Measure operator()(const Plane& plane) const
    {
        return {plane.point, 0.0, std::abs(glm::dot(eye_ - plane.point, unit(plane.normal))), 0.0, 0.0};
    }

    Measure operator()(const Disk& disk) const
    {
        const glm::dvec3 normal = unit(disk.normal);
        const glm::dvec3 offset = eye_ - disk.centre;
        const double z = glm::dot(offset, normal);
        const double aside = std::max(glm::length(offset - z * normal) - disk.radius, 0.0);
        return {disk.centre, disk.radius, std::hypot(z, aside), 0.0, 0.0};
    }

    Measure operator()(const Rectangle& rectangle) const
    {
        const glm::dvec3 corner = rectangle.corner - eye_;
        const glm::dvec3 u = rectangle.edgeU;
        const glm::dvec3 v = rectangle.edgeV;
        return {rectangle.corner, glm::length(u) + glm::length(v),
                distanceToPolygon({corner, corner + u, corner + u + v, corner + v}, normalOf(u, v)), 0.0,
                0.0};
    }

    Measure operator()(const Triangle& triangle) const
    {
        const glm::dvec3 u = triangle.b - triangle.a;
        const glm::dvec3 v = triangle.c - triangle.a;
        return {triangle.a, glm::length(u) + glm::length(v),
                distanceToPolygon({triangle.a - eye_, triangle.b - eye_, triangle.c - eye_}, normalOf(u, v)),
                0.0, 0.0};
    }

private:
    glm::dvec3 eye_;
};

Measure measureOf(const Primitive& primitive, const glm::dvec3& eye)
{
    return std::visit(Measurer(eye), primitive);
}

} // namespace

double distanceTo(const Primitive& primitive, const glm::dvec3& point)
{
    return measureOf(primitive, point).distance;
}

KernelChoice chooseKernel(const Primitive& primitive, const Camera& camera)
{
    const Measure measure = measureOf(primitive, camera.eye);
    const double fov_rad = camera.fovY_deg * std::numbers::pi / 180.0;
    const double pixel_rad = 2.0 * std::tan(0.5 * fov_rad) / finestLines;
    const double reach = glm::length(camera.eye - measure.reference) + measure.size + 2.0 * measure.distance;
    KernelChoice choice;
    choice.rounding_px = bound * std::exp2(-24.0) * reach / (measure.distance * pixel_rad);
    const bool cylinder = std::holds_alternative<Cylinder>(primitive);
    const bool fitsFine = !cylinder || (reach < mostFine && reach > 1.0 / mostFine);
    // Infinite, or no number, where the eye is upon the surface.
    const bool shows = !(choice.rounding_px <= mostRounding_px);
    if (measure.radius > mostBend * measure.toRound)
        choice.form = KernelForm::curved;
    else if (shows && fitsFine)
        choice.form = KernelForm::compensated;
    return choice;
}

namespace
{

bool finer(const KernelChoice& a, const KernelChoice& b)
{
    return a.form > b.form || (a.form == b.form && a.rounding_px > b.rounding_px);
}

// Raises each choice to what the sight asks for.
void raise(std::vector<KernelChoice>& choices, const Scene& scene, const Sight& sight)
{
    std::vector<const Primitive*> primitives;
    for (const Object& object : scene.objects)
        primitives.push_back(&object.primitive);
    for (std::size_t i = 0; i < scene.moving.size(); ++i)
        primitives[scene.moving[i]] = &sight.moving[i];
    for (std::size_t id = 0; id < choices.size(); ++id) {
        const KernelChoice choice = chooseKernel(*primitives[id], sight.camera);
        if (finer(choice, choices[id]))
            choices[id] = choice;
    }
}

} // namespace

std::vector<KernelChoice> chooseKernels(const Scene& scene)
{
    std::vector<KernelChoice> choices(scene.objects.size());
    if (scene.plan.kernels == PlanChoices::Kernels::plain)
        return choices;
    raise(choices, scene, sightOf(scene, scene.camera));
    for (const Sight& sight : scene.sights)
        raise(choices, scene, sight);
    return choices;
}

void addSights(Scene& scene, const std::vector<Sight>& sights)
{
    auto choices = chooseKernels(scene);
    for (const Sight& sight : sights) {
        auto with = choices;
        if (scene.plan.kernels != PlanChoices::Kernels::plain && sight.moving.size() == scene.moving.size())
            raise(with, scene, sight);
        if (std::ranges::equal(choices, with, {}, &KernelChoice::form, &KernelChoice::form))
            continue;
        scene.sights.push_back(sight);
        choices = std::move(with);
    }
}

} // namespace dioptre
