#include "stability/aim.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{

void setPart(RayProblem& problem, std::size_t first, const glm::dvec3& part)
{
    problem.p[first] = part.x;
    problem.p[first + 1] = part.y;
    problem.p[first + 2] = part.z;
}

glm::dvec3 partOf(const RayProblem& problem, std::size_t first)
{
    return {problem.p[first], problem.p[first + 1], problem.p[first + 2]};
}

void aim(RayProblem& problem, const glm::dvec3& origin, const glm::dvec3& target)
{
    problem.origin = asFloat(origin);
    problem.direction = asFloat(unitOf(target - problem.origin));
}

glm::dvec3 passingPoint(const glm::dvec3& origin, const glm::dvec3& centre, const glm::dvec3& aside,
                        double impact)
{
    const glm::dvec3 back = origin - centre;
    const double sine = impact / std::sqrt(glm::dot(back, back));
    return centre + impact * (sine * unitOf(back) + std::sqrt((1.0 - sine) * (1.0 + sine)) * aside);
}

void aimOverGround(RandomFloats& random, RayProblem& problem, int lowSlope)
{
    const double height = random.decades(0, 3);
    const glm::dvec3 place = random.inCube(10.0);
    problem.origin = asFloat(glm::dvec3(place.x, height, place.z));
    glm::dvec3 direction = random.direction();
    direction.y = -std::abs(direction.y);
    if (random.chance(0.5)) {
        direction = random.across({0.0, 1.0, 0.0});
        direction.y = random.decades(lowSlope, 0);
        if (random.chance(0.8))
            direction.y = -direction.y;
    }
    problem.direction = asFloat(unitOf(direction));
}

bool grazesAsWanted(double achieved, double wanted)
{
    const double size = std::abs(achieved);
    return achieved * wanted > 0.0 && size >= std::max(1e-8, 0.5 * std::abs(wanted)) &&
           size <= std::min(1e-2, 2.0 * std::abs(wanted));
}

} // namespace dioptre
