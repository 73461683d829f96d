#include "oracle/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isFinite(const RayProblem& problem)
{
    const bool finiteShape =
        std::all_of(problem.p.begin(), problem.p.end(), [](double x) { return std::isfinite(x); });
    return finiteShape && isFinite(problem.origin) && isFinite(problem.direction) &&
           std::isfinite(problem.tMin);
}

// Along the line: origin relative to the reference point.
double extentOf(const QuadShape& shape, const QuadVec& offset)
{
    const double away = glm::length(doubleFrom(offset));
    const double first = glm::length(doubleFrom(shape.first));
    const double second = glm::length(doubleFrom(shape.second));
    const auto radius = static_cast<double>(shape.radius);
    switch (shape.primitive) {
    case shapeSphere:
    case shapeDisk:
        return away + radius;
    case shapeOpenCylinder:
    case shapeCappedCylinder:
        return away + radius + first;
    case shapePlane:
        return away;
    default:
        return away + first + second;
    }
}

} // namespace

double extentOf(const RayProblem& problem)
{
    const QuadShape shape = quadShape(problem.primitive, problem.p);
    return extentOf(shape, quadFrom(problem.origin) - shape.reference);
}

RayAnswer solve(const RayProblem& problem)
{
    RayAnswer answer;
    answer.margin = std::numeric_limits<double>::infinity();
    if (!isFinite(problem) || problem.direction == glm::dvec3(0.0))
        return answer;
    const QuadShape shape = quadShape(problem.primitive, problem.p);
    if (isDegenerate(shape))
        return answer;
    const QuadRay ray{quadFrom(problem.origin), quadFrom(problem.direction)};
    const QuadRay line{ray.origin - shape.reference, ray.direction};
    constexpr double unitRoundoff = 0x1p-24;
    answer.margin = distanceToBounds(shape, line) / (unitRoundoff * extentOf(shape, line.origin));
    const QuadHit hit = firstHit(shape, ray, problem.tMin, problem.spawn);
    if (!hit.hit)
        return answer;
    answer.hit = true;
    answer.t = static_cast<double>(hit.t);
    answer.point = doubleFrom(shape.reference + hit.offset);
    answer.normal = doubleFrom(hit.normal);
    const Quad squares = dot(ray.direction, ray.direction);
    answer.cosIncidence = static_cast<double>(magnitude(dot(hit.normal, ray.direction)) / sqrtq(squares));
    return answer;
}

} // namespace dioptre
