// The colour map in which FLIP's errors are shown.
#pragma once

#include <glm/glm.hpp>

namespace dioptre
{

// Magma of van der Walt and Smith (matplotlib 1.5, 2015), from black at 0 to pale yellow at 1, growing ever
// lighter: Zucker's polynomial of degree 6 (shadertoy.com/view/WlfXRN), within 0.02 of it at each tenth part
// of its range. What lies outside 0..1 is clamped. Gives sRGB-encoded R, G, B in 0..1.
glm::dvec3 magma(double share);

} // namespace dioptre
