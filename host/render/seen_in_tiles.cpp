#include "render/picture_parts.h"
#include "scene/camera.h"
#include "scene/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre
{
namespace
{

// The pyramid of a tile's eye rays: its edges' directions, and the normals of its sides and of what lies
// in front, which point inwards.
struct Pyramid {
    std::array<glm::dvec3, 4> edges;
    std::array<glm::dvec3, 5> sides;
};

// Between two corners, given as the tangents of their angles from the camera's middle; `frame` as
// worldFromCamera().
Pyramid pyramidOf(const glm::dmat3& frame, const glm::dvec2& low, const glm::dvec2& high)
{
    const auto side = [&](double right, double up, double forward) {
        return frame * glm::dvec3(right, up, -forward);
    };
    const auto edge = [&](double x, double y) { return side(x, y, 1.0); };
    return {{edge(low.x, low.y), edge(high.x, low.y), edge(low.x, high.y), edge(high.x, high.y)},
            {side(1.0, 0.0, -low.x), side(-1.0, 0.0, high.x), side(0.0, 1.0, -low.y), side(0.0, -1.0, high.y),
             side(0.0, 0.0, 1.0)}};
}

double farthestOfDisk(const glm::dvec3& centre, const glm::dvec3& axis, double radius, const glm::dvec3& n)
{
    const double along = glm::dot(n, axis);
    return glm::dot(n, centre) + radius * std::sqrt(std::max(0.0, glm::dot(n, n) - along * along));
}

// How far a bounded shape reaches along n, seen from the eye: its support function. All of them are convex.
struct Reach {
    glm::dvec3 eye;
    glm::dvec3 n;

    double operator()(const Sphere& s) const
    {
        return glm::dot(n, s.centre - eye) + s.radius * glm::length(n);
    }
    double operator()(const Cylinder& c) const
    {
        const auto axis = unit(c.axis);
        return std::max(farthestOfDisk(c.base - eye, axis, c.radius, n),
                        farthestOfDisk(c.base + c.axis - eye, axis, c.radius, n));
    }
    double operator()(const Plane&) const
    {
        return 0.0; // endless: see meetsPlane()
    }
    double operator()(const Disk& d) const
    {
        return farthestOfDisk(d.centre - eye, unit(d.normal), d.radius, n);
    }
    double operator()(const Rectangle& r) const
    {
        return glm::dot(n, r.corner - eye) + std::max(0.0, glm::dot(n, r.edgeU)) +
               std::max(0.0, glm::dot(n, r.edgeV));
    }
    double operator()(const Triangle& t) const
    {
        return std::max({glm::dot(n, t.a - eye), glm::dot(n, t.b - eye), glm::dot(n, t.c - eye)});
    }
};

// Rays between edges that all run away from the plane run away from it too.
bool meetsPlane(const Plane& plane, const glm::dvec3& eye, const Pyramid& pyramid)
{
    const auto normal = unit(plane.normal);
    const double height = glm::dot(normal, eye - plane.point);
    constexpr double least = 1e-5;
    if (std::abs(height) < least * (glm::length(eye) + glm::length(plane.point)))
        return true;
    return std::ranges::any_of(pyramid.edges, [&](const glm::dvec3& edge) {
        const double rise = glm::dot(normal, edge) * (height > 0.0 ? 1.0 : -1.0);
        return rise < least * glm::length(edge);
    });
}

bool maySee(const Primitive& primitive, const glm::dvec3& eye, const Pyramid& pyramid)
{
    if (const auto* plane = std::get_if<Plane>(&primitive))
        return meetsPlane(*plane, eye, pyramid);
    // Floats lose a little of the numbers that the shape is made from.
    return std::ranges::all_of(pyramid.sides, [&](const glm::dvec3& side) {
        const double reach = std::visit(Reach{eye, side}, primitive);
        const double scale = std::abs(std::visit(Reach{glm::dvec3(0.0), side}, primitive)) +
                             std::abs(std::visit(Reach{glm::dvec3(0.0), -side}, primitive)) +
                             glm::length(eye) * glm::length(side);
        return reach > -1e-5 * scale;
    });
}

} // namespace

std::vector<std::vector<bool>> seenInTiles(const Scene& scene, int width, int height)
{
    constexpr double margin_px = 0.25;
    const glm::dmat3 frame = worldFromCamera(scene.camera);
    const double half = std::tan(0.5 * glm::radians(scene.camera.fovY_deg));
    const auto view = [&](double x_px, double y_px) {
        return half * glm::dvec2(2.0 * x_px - width, 2.0 * y_px - height) / static_cast<double>(height);
    };
    const int side = partTile_px(width, height);
    std::vector<std::vector<bool>> tiles;
    for (int y = 0; y < height; y += side) {
        for (int x = 0; x < width; x += side) {
            const int right = std::min(x + side, width);
            const int top = std::min(y + side, height);
            const auto pyramid = pyramidOf(frame, view(x - margin_px, y - margin_px),
                                           view(right + margin_px, top + margin_px));
            auto& seen = tiles.emplace_back();
            for (const auto& object : scene.objects)
                seen.push_back(maySee(object.primitive, scene.camera.eye, pyramid));
        }
    }
    return tiles;
}

} // namespace dioptre
