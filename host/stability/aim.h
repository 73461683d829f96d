// Rays towards a place.
#pragma once

#include "oracle/problem.h"
#include "stability/random_floats.h"

namespace dioptre
{

// Numbers p[first..first + 2] of a problem.
void setPart(RayProblem& problem, std::size_t first, const glm::dvec3& part);
glm::dvec3 partOf(const RayProblem& problem, std::size_t first);

// Sets origin and direction: both to the nearest float, the direction unit before.
void aim(RayProblem& problem, const glm::dvec3& origin, const glm::dvec3& target);

// The point nearest to `centre` on a line through `origin` that passes it at the distance `impact`, on the
// side of `aside` (unit, across centre - origin); impact < |origin - centre|.
glm::dvec3 passingPoint(const glm::dvec3& origin, const glm::dvec3& centre, const glm::dvec3& aside,
                        double impact);

// A ray of an eye 1 m to 1 km above the ground, y = 0, within 10 m of the origin: half of them anywhere
// downwards, half within slopes of 10^lowSlope..1 of the horizontal, a fifth of those upwards.
void aimOverGround(RandomFloats& random, RayProblem& problem, int lowSlope);

// Whether an offset from a silhouette that rounding changed still is what was wanted: the same sign, within a
// factor of 2 and within 1e-8..1e-2.
bool grazesAsWanted(double achieved, double wanted);

} // namespace dioptre
