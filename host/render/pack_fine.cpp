#include "render/pack_fine.h"

#include "base/as_float.h"
#include "scene/direction.h"

#include <cmath>

namespace dioptre
{
namespace
{

using packed::vec4;

vec4 lost(const glm::dvec3& value)
{
    return vec4(value - asFloat(value), 0.0);
}

class FinePacker
{
public:
    explicit FinePacker(const glm::dvec3& origin) : origin_(origin) {}

    packed::FineShape operator()(const Sphere& sphere) const
    {
        auto fine = about(sphere.centre, glm::dvec3(0.0, 1.0, 0.0));
        setPoint(fine, sphere.centre - origin_, sphere.radius, glm::dvec3(0.0, 1.0, 0.0));
        return fine;
    }

    packed::FineShape operator()(const Cylinder& cylinder) const
    {
        auto fine = about(cylinder.base, cylinder.axis);
        const glm::dvec3 axis = unit(cylinder.axis);
        const glm::dvec3 base = cylinder.base - origin_;
        // The axis' point nearest to the scene origin.
        const double above = -glm::dot(base, axis);
        setPoint(fine, base + above * axis, cylinder.radius, perpendicularTo(axis));
        fine.point_normal.w = above;
        return fine;
    }

    packed::FineShape operator()(const Plane& plane) const
    {
        return about(plane.point, unit(plane.normal));
    }

    packed::FineShape operator()(const Disk& disk) const
    {
        return about(disk.centre, unit(disk.normal));
    }

    packed::FineShape operator()(const Rectangle& rectangle) const
    {
        const glm::dvec3 across = glm::cross(unit(rectangle.edgeU), unit(rectangle.edgeV));
        return about(rectangle.corner, unit(across));
    }

    packed::FineShape operator()(const Triangle& triangle) const
    {
        const glm::dvec3 u = unit(triangle.b - triangle.a);
        const glm::dvec3 v = unit(triangle.c - triangle.a);
        auto fine = about(triangle.a, unit(glm::cross(u, v)));
        fine.along_u_low = lost(triangle.b - origin_);
        fine.along_v_low = lost(triangle.c - origin_);
        return fine;
    }

private:
    packed::FineShape about(const glm::dvec3& anchor, const glm::dvec3& axis) const
    {
        packed::FineShape fine{};
        fine.anchor_low = lost(anchor - origin_);
        fine.axis = vec4(axis, 0.0);
        fine.axis_low = lost(axis);
        return fine;
    }

    // Some unit vector at right angles to a unit one.
    static glm::dvec3 perpendicularTo(const glm::dvec3& axis)
    {
        const bool upright = std::abs(axis.y) > 0.9;
        return unit(glm::cross(axis, upright ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)));
    }

    // The point of a round surface nearest to the scene origin; `middle` is its centre, or its axis' point
    // there.
    static void setPoint(packed::FineShape& fine, const glm::dvec3& middle, double radius,
                         const glm::dvec3& otherwise)
    {
        const double distance = std::sqrt(glm::dot(middle, middle));
        const glm::dvec3 normal = distance > 0.0 ? -middle / distance : otherwise;
        fine.point = vec4((radius - distance) * normal, 1.0 / radius);
        fine.point_normal = vec4(normal, 0.0);
        fine.point_normal_low = lost(normal);
    }

    glm::dvec3 origin_;
};

} // namespace

packed::FineShape packFine(const Primitive& primitive, const glm::dvec3& origin)
{
    return std::visit(FinePacker(origin), primitive);
}

} // namespace dioptre
