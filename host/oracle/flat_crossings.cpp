// Planes, disks, rectangles and triangles: the implicit equation is linear along the line.
#include "oracle/crossing.h"

namespace dioptre
{
namespace
{

// Whether a point of the plane lies between the edges: its shares of them from the normal equations, times
// their determinant, which is positive.
bool betweenEdges(const QuadShape& shape, const QuadVec& point)
{
    const Quad uu = dot(shape.first, shape.first);
    const Quad uv = dot(shape.first, shape.second);
    const Quad vv = dot(shape.second, shape.second);
    const Quad pu = dot(point, shape.first);
    const Quad pv = dot(point, shape.second);
    const Quad whole = uu * vv - uv * uv;
    const Quad u = pu * vv - pv * uv;
    const Quad v = pv * uu - pu * uv;
    if (u < 0 || v < 0)
        return false;
    return shape.primitive == shapeTriangle ? u + v <= whole : u <= whole && v <= whole;
}

bool onShape(const QuadShape& shape, const QuadVec& point)
{
    switch (shape.primitive) {
    case shapePlane:
        return true;
    case shapeDisk:
        return dot(point, point) <= shape.radius * shape.radius;
    default:
        return betweenEdges(shape, point);
    }
}

} // namespace

SurfaceCrossings flatCrossings(const QuadShape& shape, const QuadRay& line)
{
    const bool hasEdges = shape.primitive == shapeRectangle || shape.primitive == shapeTriangle;
    const QuadVec normal = hasEdges ? cross(shape.first, shape.second) : shape.first;
    const Quad approach = dot(line.direction, normal);
    SurfaceCrossings crossings;
    if (approach == 0)
        return crossings;
    const Quad t = -dot(line.origin, normal) / approach;
    crossings.add({t, Face::side, onShape(shape, line.origin + t * line.direction)});
    return crossings;
}

} // namespace dioptre
