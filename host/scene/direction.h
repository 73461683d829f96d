// Questions about vectors whose answers do not change when the whole scene is scaled.
#pragma once

#include <glm/glm.hpp>

namespace dioptre
{

// The vector over its length, safe from overflow and underflow of its square; not for the zero vector.
glm::dvec3 unit(const glm::dvec3& vector);

// The unit vector at right angles to two that are not parallel, right-handed; as safe.
glm::dvec3 normalOf(const glm::dvec3& u, const glm::dvec3& v);

// Whether the sine of the angle between two vectors is as good as 0; a zero vector is parallel to everything.
bool parallel(const glm::dvec3& u, const glm::dvec3& v);

// Whether two points are as good as one, measured by their distance from the origin.
bool coincident(const glm::dvec3& a, const glm::dvec3& b);

} // namespace dioptre
