// Where a line crosses a round surface: roots of the implicit equation |p|^2 = R^2 along it, between
// brackets.
#pragma once

#include "oracle/quad.h"

#include <array>

namespace dioptre
{

struct LineRoots {
    int count = 0; // 0 or 2; a line that touches has the same root twice
    std::array<Quad, 2> t{};
};

// All t at which |offset + t direction| = radius, in rising order; radius > 0. A zero direction has none.
LineRoots roundRoots(const QuadVec& offset, const QuadVec& direction, Quad radius);

} // namespace dioptre
