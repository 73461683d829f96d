// What light does at a smooth interface, by the angles of incidence and refraction; evaluated in quad
// precision.
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace dioptre
{

// Shares of unpolarised light; transmitted by its own formula, so that their sum of 1 is a check.
struct FresnelShares {
    double reflected = 0.0;
    double transmitted = 0.0;
};

// cosIncidence 0..1; index = n_t / n_i > 0. From total reflection on 1 and 0; index 1 lets all through at any
// angle. Fresnel's sine and tangent laws: Born and Wolf, "Principles of Optics", section 1.5.2.
FresnelShares fresnelShares(double cosIncidence, double index);

// Snell's law: the unit direction behind the interface, or nothing under total reflection. Direction and
// normal of any length but 0; the normal may point to either side. index = n_t / n_i > 0.
std::optional<glm::dvec3> snellDirection(const glm::dvec3& direction, const glm::dvec3& normal, double index);

// The unit direction after a mirror, by turning through pi - 2i in the plane of incidence. Vectors of any
// length but 0.
glm::dvec3 mirroredDirection(const glm::dvec3& direction, const glm::dvec3& normal);

} // namespace dioptre
