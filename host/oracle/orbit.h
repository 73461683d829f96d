// Orbits of a ray among mirror spheres, which amplify every error by a fixed factor a bounce: Gaspard and
// Rice, "Scattering from a classically chaotic repellor", 1989. In quad precision some 33 digits outlast
// every orbit asked for here.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace dioptre
{

struct MirrorSphere {
    glm::dvec3 centre{0.0}; // metres
    double radius = 1.0;    // metres, above 0
};

struct OrbitStop {
    int sphere = 0;        // index of the sphere that was hit
    glm::dvec3 point{0.0}; // metres
};

// `count` spheres, 2 to 4, all `distance` from one another, in lengths of their radius of 1: on the x axis,
// at the corners of a triangle in the plane z = 0, of a tetrahedron; their centres' mean is the origin.
std::vector<MirrorSphere> mirrorSpheres(int count, double distance);

// Where the ray is reflected, in order, until it escapes or has met `most` spheres. It starts outside all of
// them, the spheres apart from one another; direction of any length but 0.
std::vector<OrbitStop> mirrorOrbit(std::span<const MirrorSphere> spheres, const glm::dvec3& origin,
                                   const glm::dvec3& direction, int most);

// By how much an error of the start grows per bounce along this orbit, as log10: the distance of two orbits
// in quad precision that start 1e-28 of the largest radius apart, from the first stop to the last at which
// they are within 1e-6 of it. 0 if there are fewer than two such stops.
double orbitGrowth_log10(std::span<const MirrorSphere> spheres, const glm::dvec3& origin,
                         const glm::dvec3& direction, int most);

// Of the orbit between two spheres along the line of their centres: log10 of 1 + L/R + sqrt((1 + L/R)^2 - 1)
// with the gap L = distance - 2 R between them. distance > 2 radius.
double twoSphereGrowth_log10(double distance, double radius);

} // namespace dioptre
