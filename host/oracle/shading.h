// What a surface, a light and a display make of light, each from its definition by angles; evaluated in quad
// precision.
#pragma once

#include "base/tone_curve.h"

#include <glm/glm.hpp>

namespace dioptre
{

// Trowbridge and Reitz's distribution of microfacet normals, 1/sr: Walter et al., "Microfacet models for
// refraction through rough surfaces", 2007, eq. 33. Vectors of any length but 0, alpha > 0; 0 where they are
// 90 degrees apart or more.
double microfacetDensity(const glm::dvec3& normal, const glm::dvec3& half, double alpha);

// cos^exponent of the angle between two vectors of any length but 0; 0 where it is 90 degrees or more.
// exponent >= 0.
double cosineLobe(const glm::dvec3& a, const glm::dvec3& b, double exponent);

struct SpotCone {
    bool inside = false;   // the rim counts
    double strength = 0.0; // cos^exponent inside, 0 outside
};

// `axis` runs from the light along its middle, `fromLight` to the point that it lights; any length but 0.
// cutoff_rad 0..pi.
SpotCone spotCone(const glm::dvec3& axis, const glm::dvec3& fromLight, double cutoff_rad, double exponent);

// 1 / (c + l d + q d^2) at distance d but at least nearest_m; coefficients = (c, l, q).
double attenuationAt(const glm::dvec3& coefficients, double distance_m, double nearest_m);

// Where a latitude-longitude map shows a direction of any length but 0: u = 0.5 + atan2(x, z) / 2 pi, 0.5 at
// the poles; v = 0.5 + (latitude) / pi.
glm::dvec2 latLongPlace(const glm::dvec3& direction);

// What a display is sent for this radiance, 0..1: exposure, curve and the sRGB or gamma encoding of
// `display`. 0 for NaN, and for what is below 0.
double displayValue(double radiance, const Display& display);

} // namespace dioptre
