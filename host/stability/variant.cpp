#include "stability/variant.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

constexpr double hugeRadius = 1e4; // of the distance

glm::dvec3 part(const RayProblem& problem, std::size_t first)
{
    return {problem.p[first], problem.p[first + 1], problem.p[first + 2]};
}

bool isRound(int primitive)
{
    return primitive >= shapeSphere && primitive <= shapeCappedCylinder;
}

// Of a point from the surface of a sphere or of an endless cylinder.
double distanceOf(const RayProblem& problem, const glm::dvec3& point)
{
    const bool sphere = problem.primitive == shapeSphere;
    glm::dvec3 offset = point - part(problem, 0);
    if (!sphere) {
        const glm::dvec3 axis = part(problem, 3);
        offset -= glm::dot(offset, axis) / glm::dot(axis, axis) * axis;
    }
    return std::abs(glm::length(offset) - problem.p[sphere ? 3 : 6]);
}

} // namespace

std::string_view nameOf(Variant variant)
{
    return std::ranges::find(variantNames, variant, &VariantName::variant)->name;
}

bool isFor(Variant variant, int primitive)
{
    return variant != Variant::curvature || isRound(primitive);
}

Variant strictestFor(const RayProblem& problem, const glm::dvec3& frameOrigin)
{
    if (!isRound(problem.primitive))
        return Variant::compensated;
    const double radius = problem.p[problem.primitive == shapeSphere ? 3 : 6];
    const double distance =
        std::max(distanceOf(problem, frameOrigin), glm::length(problem.origin - frameOrigin));
    return radius > hugeRadius * distance ? Variant::curvature : Variant::compensated;
}

} // namespace dioptre
