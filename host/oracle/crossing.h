// Where a line meets the surface of a primitive, in quad precision, and the first of these that a ray meets.
#pragma once

#include "oracle/problem.h"
#include "oracle/quad.h"

#include <array>

namespace dioptre
{

struct QuadRay {
    QuadVec origin, direction; // the direction of any length but 0
};

// A primitive's numbers, laid out as RayProblem says.
struct QuadShape {
    int primitive = shapeSphere;
    QuadVec reference{}; // centre, base, point, corner or a
    QuadVec first{};     // axis, normal, edge u or b - a
    QuadVec second{};    // edge v or c - a
    Quad radius = 0;
};

enum class Face { side, baseCap, topCap };

// One meeting of the line with the primitive's unbounded surfaces.
struct SurfaceCrossing {
    Quad t = 0;
    Face face = Face::side;
    bool onShape = false; // within the height, the rim or the edges
};

// In no order; spheres 2, cylinders up to 4, flat shapes 1.
struct SurfaceCrossings {
    int count = 0;
    std::array<SurfaceCrossing, 4> at{};

    void add(const SurfaceCrossing& crossing)
    {
        at[static_cast<std::size_t>(count++)] = crossing;
    }
};

struct QuadHit {
    bool hit = false;
    Quad t = 0;
    QuadVec offset{}; // of the hit from the shape's reference point
    QuadVec normal{}; // unit, as RayAnswer says
};

QuadShape quadShape(int primitive, const std::array<double, 9>& p);

// Whether the primitive has an extent to be hit: see solve(). Its numbers must be finite.
bool isDegenerate(const QuadShape& shape);

// Of round and of flat shapes; `line` starts relative to the reference point. The shape must not be
// degenerate.
SurfaceCrossings roundCrossings(const QuadShape& shape, const QuadRay& line);
SurfaceCrossings flatCrossings(const QuadShape& shape, const QuadRay& line);

// The first hit beyond tMin, as solve() says, for a ray that itself has quad's digits. The shape must not be
// degenerate.
QuadHit firstHit(const QuadShape& shape, const QuadRay& ray, Quad tMin, bool spawn);

} // namespace dioptre
