#include "oracle/crossing.h"

namespace dioptre
{
namespace
{

bool isZero(const QuadVec& v)
{
    return v.x == 0 && v.y == 0 && v.z == 0;
}

// The crossing that a ray starting on the surface leaves by. An open wall is left where the line crosses it
// even if rounding put that just beyond a rim; a capped cylinder's surfaces count only where they are its
// own.
int nearestToOrigin(const SurfaceCrossings& crossings, bool solid)
{
    int nearest = -1;
    for (int i = 0; i < crossings.count; ++i) {
        const SurfaceCrossing& crossing = crossings.at[static_cast<std::size_t>(i)];
        if (solid && !crossing.onShape)
            continue;
        if (nearest < 0 ||
            magnitude(crossing.t) < magnitude(crossings.at[static_cast<std::size_t>(nearest)].t))
            nearest = i;
    }
    return nearest;
}

// As RayAnswer says; `offset` is of the crossing from the reference point.
QuadVec normalAt(const QuadShape& shape, Face face, const QuadVec& offset)
{
    switch (shape.primitive) {
    case shapeSphere:
        return unit(offset);
    case shapeOpenCylinder:
    case shapeCappedCylinder:
        if (face == Face::side)
            return unit(offset - (dot(offset, shape.first) / dot(shape.first, shape.first)) * shape.first);
        return (face == Face::topCap ? 1 : -1) * unit(shape.first);
    case shapePlane:
    case shapeDisk:
        return unit(shape.first);
    default:
        return unit(cross(shape.first, shape.second));
    }
}

} // namespace

QuadShape quadShape(int primitive, const std::array<double, 9>& p)
{
    QuadShape shape;
    shape.primitive = primitive;
    shape.reference = {p[0], p[1], p[2]};
    shape.first = {p[3], p[4], p[5]};
    shape.second = {p[6], p[7], p[8]};
    switch (primitive) {
    case shapeSphere:
        shape.radius = p[3];
        break;
    case shapeOpenCylinder:
    case shapeCappedCylinder:
    case shapeDisk:
        shape.radius = p[6];
        break;
    case shapeTriangle:
        shape.first = shape.first - shape.reference;
        shape.second = shape.second - shape.reference;
        break;
    default:
        break;
    }
    return shape;
}

bool isDegenerate(const QuadShape& shape)
{
    switch (shape.primitive) {
    case shapeSphere:
        return !(shape.radius > 0);
    case shapeOpenCylinder:
    case shapeCappedCylinder:
    case shapeDisk:
        return !(shape.radius > 0) || isZero(shape.first);
    case shapePlane:
        return isZero(shape.first);
    case shapeRectangle:
    case shapeTriangle:
        return isZero(cross(shape.first, shape.second));
    default:
        return true;
    }
}

QuadHit firstHit(const QuadShape& shape, const QuadRay& ray, Quad tMin, bool spawn)
{
    const QuadRay line{ray.origin - shape.reference, ray.direction};
    const bool round = shape.primitive <= shapeCappedCylinder;
    const SurfaceCrossings crossings = round ? roundCrossings(shape, line) : flatCrossings(shape, line);
    const int own = spawn ? nearestToOrigin(crossings, shape.primitive == shapeCappedCylinder) : -1;
    QuadHit first;
    Face face = Face::side;
    for (int i = 0; i < crossings.count; ++i) {
        const SurfaceCrossing& crossing = crossings.at[static_cast<std::size_t>(i)];
        if (i == own || !crossing.onShape || crossing.t <= tMin || (first.hit && first.t <= crossing.t))
            continue;
        first.hit = true;
        first.t = crossing.t;
        face = crossing.face;
    }
    if (first.hit) {
        first.offset = line.origin + first.t * line.direction;
        first.normal = normalAt(shape, face, first.offset);
    }
    return first;
}

} // namespace dioptre
