// Paths through glass and between mirrors whose end is known in closed form, whatever the number of bounces;
// evaluated in quad precision.
#pragma once

#include <glm/glm.hpp>

namespace dioptre
{

// Angle by which a ray turns that passes once through a ball, 2 (i - r): refracted in, refracted out.
// `offset` is its line's distance from the centre over the radius, 0..1; index > 1.
double ballDeviation_rad(double offset, double index);

// How far a ray is shifted across itself by a slab: d sin(i - r) / cos r. incidence_rad in 0..pi/2, index
// > 1.
double slabOffset_m(double thickness_m, double incidence_rad, double index);

struct MirrorStop {
    glm::dvec3 point{0.0};     // metres
    glm::dvec3 direction{0.0}; // unit, after the bounce
    double length_m = 0.0;     // of the path so far
};

// The bounce number `bounce` (from 1) between mirrors in the planes z = 0 and z = gap_m, by unfolding: in the
// row of mirrored rooms the path is one straight line. The origin lies between them, direction.z is not 0, of
// any length.
MirrorStop facingMirrors(double gap_m, const glm::dvec3& origin, const glm::dvec3& direction, int bounce);

// A whispering gallery: inside a mirror circle about the origin a ray leaves the point (radius, 0)
// counter-clockwise, glancing_rad from the tangent. Every chord spans an angle of 2 glancing_rad at the
// centre. The point of bounce number `bounce`, from 1; metres.
glm::dvec2 whisperingGallery(double radius_m, double glancing_rad, int bounce);

} // namespace dioptre
