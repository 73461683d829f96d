// Spheres and cylinders. A cylinder's side is a circle in the plane across its axis.
#include "oracle/crossing.h"
#include "oracle/line_roots.h"

namespace dioptre
{
namespace
{

void addSide(SurfaceCrossings& crossings, const LineRoots& roots, Quad height, Quad climb)
{
    for (int i = 0; i < roots.count; ++i) {
        const Quad t = roots.t[static_cast<std::size_t>(i)];
        const Quad z = height + t * climb;
        crossings.add({t, Face::side, z >= 0 && z <= 1});
    }
}

// `across` is the line's projection onto the plane across the axis.
void addCap(SurfaceCrossings& crossings, const QuadRay& across, Quad radius, Quad t, Face face)
{
    const QuadVec p = across.origin + t * across.direction;
    crossings.add({t, face, dot(p, p) <= radius * radius});
}

SurfaceCrossings cylinderCrossings(const QuadShape& shape, const QuadRay& line)
{
    // Heights in lengths of the axis: 0 at the base, 1 at the top.
    const Quad perSquare = 1 / dot(shape.first, shape.first);
    const Quad height = dot(line.origin, shape.first) * perSquare;
    const Quad climb = dot(line.direction, shape.first) * perSquare;
    const QuadRay across{line.origin - height * shape.first, line.direction - climb * shape.first};
    SurfaceCrossings crossings;
    addSide(crossings, roundRoots(across.origin, across.direction, shape.radius), height, climb);
    if (shape.primitive == shapeCappedCylinder && climb != 0) {
        addCap(crossings, across, shape.radius, -height / climb, Face::baseCap);
        addCap(crossings, across, shape.radius, (1 - height) / climb, Face::topCap);
    }
    return crossings;
}

} // namespace

SurfaceCrossings roundCrossings(const QuadShape& shape, const QuadRay& line)
{
    if (shape.primitive != shapeSphere)
        return cylinderCrossings(shape, line);
    SurfaceCrossings crossings;
    const LineRoots roots = roundRoots(line.origin, line.direction, shape.radius);
    for (int i = 0; i < roots.count; ++i)
        crossings.add({roots.t[static_cast<std::size_t>(i)], Face::side, true});
    return crossings;
}

} // namespace dioptre
