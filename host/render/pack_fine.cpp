#include "render/pack_fine.h"

#include "base/as_float.h"
#include "scene/direction.h"

#include <cmath>

namespace dioptre
{
namespace
{

using glm::dvec3;
using packed::vec4;

vec4 lost(const vec4& row)
{
    const dvec3 value(row);
    return vec4(value - asFloat(value), 0.0);
}

// Some unit vector at right angles to a unit one.
dvec3 perpendicularTo(const dvec3& axis)
{
    const bool upright = std::abs(axis.y) > 0.9;
    return unit(glm::cross(axis, upright ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0)));
}

// The point of a round surface nearest to the scene origin. `middle` is its centre, or the point of its axis
// nearest to there; from the very middle any normal across the axis will do.
void setPoint(packed::FineShape& fine, const dvec3& middle, const packed::Shape& shape)
{
    const double radius = shape.anchor.w;
    const double distance = glm::length(middle);
    const dvec3 normal = distance > 0.0 ? -middle / distance : perpendicularTo(dvec3(shape.axis));
    fine.point = vec4((radius - distance) * normal, 1.0 / radius);
    fine.point_normal = vec4(normal, 0.0);
    fine.point_normal_low = lost(fine.point_normal);
}

} // namespace

packed::FineShape packFine(const PackedObject& object)
{
    const packed::Shape& shape = object.shape;
    const bool cylinder =
        object.kind == packed::KIND_OPEN_CYLINDER || object.kind == packed::KIND_CAPPED_CYLINDER;
    packed::FineShape fine{};
    fine.anchor_low = lost(shape.anchor);
    fine.axis = vec4((cylinder ? shape.axis.w : 1.0) * dvec3(shape.axis), 0.0);
    fine.axis_low = lost(fine.axis);
    fine.along_u_low = lost(shape.along_u);
    fine.along_v_low = lost(shape.along_v);
    if (object.kind == packed::KIND_SPHERE)
        setPoint(fine, dvec3(shape.anchor), shape);
    if (cylinder) {
        const double above = -glm::dot(dvec3(shape.anchor), dvec3(shape.axis));
        setPoint(fine, dvec3(shape.anchor) + above * dvec3(shape.axis), shape);
        fine.point_normal.w = above;
    }
    return fine;
}

} // namespace dioptre
