#include "scene/direction.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{

namespace
{

// Far above the rounding of doubles, far below any angle or distance that an author means.
constexpr double negligible = 1e-12;

double largestPart(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

glm::dvec3 unit(const glm::dvec3& vector)
{
    const glm::dvec3 scaled = vector / largestPart(vector);
    return scaled / glm::length(scaled);
}

glm::dvec3 normalOf(const glm::dvec3& u, const glm::dvec3& v)
{
    return unit(glm::cross(unit(u), unit(v)));
}

bool parallel(const glm::dvec3& u, const glm::dvec3& v)
{
    if (largestPart(u) == 0.0 || largestPart(v) == 0.0)
        return true;
    return glm::length(glm::cross(unit(u), unit(v))) <= negligible;
}

bool coincident(const glm::dvec3& a, const glm::dvec3& b)
{
    return largestPart(a - b) <= negligible * std::max(largestPart(a), largestPart(b));
}

} // namespace dioptre
