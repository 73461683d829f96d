// Problems whose answers are known, and their images under a scaling and a turn that both are exact.
#pragma once

#include "oracle/problem.h"

namespace dioptre
{

inline RayProblem problemOf(int primitive, const std::array<double, 9>& p, const glm::dvec3& origin,
                            const glm::dvec3& direction)
{
    RayProblem problem;
    problem.primitive = primitive;
    problem.p = p;
    problem.origin = origin;
    problem.direction = direction;
    return problem;
}

// Three times a rotation, in whole numbers: what it does to whole numbers is exact.
inline glm::dvec3 tripleTurn(const glm::dvec3& v)
{
    return {v.x + 2.0 * v.y - 2.0 * v.z, 2.0 * v.x + v.y + 2.0 * v.z, 2.0 * v.x - 2.0 * v.y - v.z};
}

inline void setPart(std::array<double, 9>& p, std::size_t first, const glm::dvec3& v)
{
    p[first] = v.x;
    p[first + 1] = v.y;
    p[first + 2] = v.z;
}

inline glm::dvec3 partOf(const std::array<double, 9>& p, std::size_t first)
{
    return {p[first], p[first + 1], p[first + 2]};
}

// The whole problem, its direction included, under v -> scale * tripleTurn(v) + shift: t, cosines stay,
// lengths grow by 3 scale. Exact for small whole numbers, a power of two and a shift in the reach of their
// sum.
inline RayProblem imageOf(const RayProblem& problem, double scale, const glm::dvec3& shift = glm::dvec3(0.0))
{
    RayProblem image = problem;
    const auto place = [&](const glm::dvec3& v) { return scale * tripleTurn(v) + shift; };
    const auto span = [&](const glm::dvec3& v) { return scale * tripleTurn(v); };
    setPart(image.p, 0, place(partOf(problem.p, 0)));
    switch (problem.primitive) {
    case shapeSphere:
        image.p[3] = 3.0 * scale * problem.p[3];
        break;
    case shapeOpenCylinder:
    case shapeCappedCylinder:
    case shapeDisk:
        setPart(image.p, 3, span(partOf(problem.p, 3)));
        image.p[6] = 3.0 * scale * problem.p[6];
        break;
    case shapePlane:
        setPart(image.p, 3, span(partOf(problem.p, 3)));
        break;
    case shapeRectangle:
        setPart(image.p, 3, span(partOf(problem.p, 3)));
        setPart(image.p, 6, span(partOf(problem.p, 6)));
        break;
    default:
        setPart(image.p, 3, place(partOf(problem.p, 3)));
        setPart(image.p, 6, place(partOf(problem.p, 6)));
    }
    image.origin = place(problem.origin);
    image.direction = span(problem.direction);
    return image;
}

} // namespace dioptre
