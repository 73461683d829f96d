#include "raster/extent.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// Half of what a disk of that radius spans.
double diskReach(const glm::dvec3& normal, double radius, const glm::dvec3& direction)
{
    const glm::dvec3 within = direction - glm::dot(direction, normal) * normal;
    return radius * glm::length(within);
}

Extent about(double middle, double reach)
{
    return {middle - reach, middle + reach};
}

Extent ofCorners(std::initializer_list<double> corners)
{
    return {std::min(corners), std::max(corners)};
}

// The edge that belongs to a rectangle's dual vector; see dualEdge() of glsl/raster/unit_shape.glsl.
glm::dvec3 dualEdge(const glm::dvec3& own, const glm::dvec3& other, const glm::dvec3& normal)
{
    const glm::dvec3 across = glm::cross(other, normal);
    return across / glm::dot(own, across);
}

} // namespace

Extent extentAlong(const PackedObject& object, const glm::dvec3& direction)
{
    const packed::Shape& shape = object.shape;
    const glm::dvec3 anchor(shape.anchor);
    const glm::dvec3 axis(shape.axis);
    const glm::dvec3 u(shape.along_u);
    const glm::dvec3 v(shape.along_v);
    const double middle = glm::dot(anchor, direction);
    const auto along = [&](const glm::dvec3& offset) { return middle + glm::dot(offset, direction); };
    switch (object.kind) {
    case packed::KIND_SPHERE:
        return about(middle, shape.anchor.w * glm::length(direction));
    case packed::KIND_OPEN_CYLINDER:
    case packed::KIND_CAPPED_CYLINDER: {
        const double reach = diskReach(axis, shape.anchor.w, direction);
        const Extent ends = ofCorners({middle, along(shape.axis.w * axis)});
        return {ends.low - reach, ends.high + reach};
    }
    case packed::KIND_DISK:
        return about(middle, diskReach(axis, shape.anchor.w, direction));
    case packed::KIND_PLANE:
        return about(middle,
                     shape.anchor.w * (std::abs(glm::dot(u, direction)) + std::abs(glm::dot(v, direction))));
    case packed::KIND_RECTANGLE: {
        const glm::dvec3 first = dualEdge(u, v, axis);
        const glm::dvec3 second = dualEdge(v, u, axis);
        return ofCorners({middle, along(first), along(second), along(first + second)});
    }
    default:
        return ofCorners({middle, glm::dot(u, direction), glm::dot(v, direction)});
    }
}

} // namespace dioptre
