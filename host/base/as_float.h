// Rounding to single precision, in doubles.
#pragma once

#include <glm/glm.hpp>

namespace dioptre
{

// To the nearest float; a device gets what double precision reckons with.
double asFloat(double value);
glm::dvec3 asFloat(const glm::dvec3& value);

} // namespace dioptre
