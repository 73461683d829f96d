// Angles between vectors in double precision.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace dioptre
{

// 0..pi, of vectors of any length but 0. The sine keeps the digits of a small angle.
inline double angleBetween_rad(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace dioptre
