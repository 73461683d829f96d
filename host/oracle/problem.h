// A ray and a primitive, and where they truly meet: what a kernel's answer is held against.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <string>

namespace dioptre
{

// The shapes of glsl/shared/constants.glsl, by their numbers there.
enum ProblemShape : int {
    shapeSphere = 0,
    shapeOpenCylinder = 1,
    shapeCappedCylinder = 2,
    shapePlane = 3,
    shapeDisk = 4,
    shapeRectangle = 5,
    shapeTriangle = 6
};

struct RayProblem {
    std::string caseName; // of the suite's table: "S01"
    std::string id;       // tells it from the other problems of its case
    int primitive = shapeSphere;
    // Metres. Sphere: centre, radius. Cylinder: base, axis (its length is the height), radius. Plane: point,
    // normal (any length). Disk: centre, normal (any length), radius. Rectangle: corner, edge, edge, not
    // always at right angles. Triangle: a, b, c.
    std::array<double, 9> p{};
    glm::dvec3 origin{0.0};    // metres
    glm::dvec3 direction{0.0}; // any length but 0
    double tMin = 0.0;         // only what is met beyond it counts; in lengths of the direction
    bool spawn = false;        // the origin lies on the surface: the crossing nearest to it does not count
};

struct RayAnswer {
    bool hit = false;
    double t = 0.0;        // of the first hit beyond tMin, in lengths of the direction
    glm::dvec3 point{0.0}; // metres
    // Unit, the surface's own: out of a sphere or cylinder, a cap's along the axis away from the solid, a
    // flat shape's along the given normal, a rectangle's u x v, a triangle's (b - a) x (c - a).
    glm::dvec3 normal{0.0};
    double cosIncidence = 0.0; // magnitude of the cosine of direction and normal
    // How far the ray's line passes from what bounds the shape as the ray sees it, in units of 2^-24 (|o - r|
    // + s): a sphere's silhouette; a cylinder's rims and its wall's silhouette between them; the edge of a
    // disk, rectangle or triangle. Infinite for a plane that the ray does not run along, and for a degenerate
    // problem. r and s: sphere centre, radius; cylinder base, radius + height; plane point, 0; disk centre,
    // radius; rectangle corner, |u| + |v|; triangle a, |b - a| + |c - a|.
    double margin = 0.0;
};

// The first hit beyond tMin, in quad precision. A line that touches counts as hitting; a ray within a flat
// shape misses it. A degenerate problem is a miss: a radius that is not positive, a zero axis, normal or
// direction, edges or corners on one line, any number that is not finite, a kind that is none.
RayAnswer solve(const RayProblem& problem);

// |o - r| + s of the problem, metres: what errors of its answer are measured by.
double extentOf(const RayProblem& problem);

} // namespace dioptre
