#include "render/pack.h"

#include "scene/direction.h"

#include <cmath>
#include <numbers>

namespace dioptre
{
namespace
{

using packed::vec4;

// Safe from underflow of the square, as unit() is.
double lengthOf(const glm::dvec3& vector)
{
    return glm::dot(vector, unit(vector));
}

// Unit vectors along a flat shape with u x v = normal: u = x and v = -z on a floor, u horizontal on walls;
// turned about the normal.
struct Frame {
    glm::dvec3 u, v;
};

Frame frameAbout(const glm::dvec3& normal, double turn_rad)
{
    const bool level = std::abs(normal.y) > 0.999;
    const glm::dvec3 reference = level ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = unit(glm::cross(reference, normal));
    const glm::dvec3 v = glm::cross(normal, u);
    return {std::cos(turn_rad) * u + std::sin(turn_rad) * v, std::cos(turn_rad) * v - std::sin(turn_rad) * u};
}

class ShapePacker
{
public:
    ShapePacker(const glm::dvec3& origin, double turn_rad) : origin_(origin), turn_rad_(turn_rad) {}

    PackedObject operator()(const Sphere& sphere) const
    {
        auto result = flat(packed::KIND_SPHERE, sphere.centre, glm::dvec3(0.0, 1.0, 0.0));
        result.shape.anchor.w = sphere.radius;
        return round(result);
    }

    PackedObject operator()(const Cylinder& cylinder) const
    {
        const double height = lengthOf(cylinder.axis);
        const int kind = cylinder.capped ? packed::KIND_CAPPED_CYLINDER : packed::KIND_OPEN_CYLINDER;
        auto result = flat(kind, cylinder.base, unit(cylinder.axis));
        result.shape.anchor.w = cylinder.radius;
        result.shape.axis.w = height;
        return round(result);
    }

    PackedObject operator()(const Plane& plane) const
    {
        return flat(packed::KIND_PLANE, plane.point, unit(plane.normal));
    }

    PackedObject operator()(const Disk& disk) const
    {
        auto result = flat(packed::KIND_DISK, disk.centre, unit(disk.normal));
        result.shape.anchor.w = disk.radius;
        return result;
    }

    PackedObject operator()(const Rectangle& rectangle) const
    {
        const glm::dvec3 u = unit(rectangle.edgeU);
        const glm::dvec3 v = unit(rectangle.edgeV);
        const glm::dvec3 across = glm::cross(u, v);
        const double lengthU = lengthOf(rectangle.edgeU);
        const double lengthV = lengthOf(rectangle.edgeV);
        auto result = edged(packed::KIND_RECTANGLE, rectangle.corner, u, v);
        // The dual basis: maps an offset to its shares of u and v, parallelogram or not.
        result.shape.along_u = vec4(glm::cross(v, across) / glm::dot(across, across) / lengthU, lengthU);
        result.shape.along_v = vec4(glm::cross(across, u) / glm::dot(across, across) / lengthV, lengthV);
        return result;
    }

    PackedObject operator()(const Triangle& triangle) const
    {
        const glm::dvec3 u = triangle.b - triangle.a;
        const glm::dvec3 v = triangle.c - triangle.a;
        auto result = edged(packed::KIND_TRIANGLE, triangle.a, u, v);
        result.shape.along_u = vec4(triangle.b - origin_, lengthOf(u));
        result.shape.along_v = vec4(triangle.c - origin_, lengthOf(v));
        return result;
    }

private:
    PackedObject flat(int kind, const glm::dvec3& anchor, const glm::dvec3& axis) const
    {
        const Frame frame = frameAbout(axis, turn_rad_);
        PackedObject result;
        result.kind = kind;
        result.shape.anchor = vec4(anchor - origin_, 0.0);
        result.shape.axis = vec4(axis, 0.0);
        result.shape.along_u = vec4(frame.u, 0.0);
        result.shape.along_v = vec4(frame.v, 0.0);
        return result;
    }

    // Round shapes measure longitude from along_v towards along_u, as latLong() does from z towards x.
    static PackedObject round(PackedObject result)
    {
        result.shape.along_v = vec4(-glm::dvec3(result.shape.along_v), 0.0);
        return result;
    }

    PackedObject edged(int kind, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) const
    {
        PackedObject result;
        result.kind = kind;
        result.shape.anchor = vec4(corner - origin_, std::cos(turn_rad_));
        result.shape.axis = vec4(normalOf(u, v), std::sin(turn_rad_));
        return result;
    }

    glm::dvec3 origin_;
    double turn_rad_;
};

} // namespace

PackedObject packShape(const Object& object, const glm::dvec3& origin)
{
    const double turn_rad = object.rotateTexture_deg * std::numbers::pi / 180.0;
    return std::visit(ShapePacker(origin, turn_rad), object.primitive);
}

} // namespace dioptre
