#include "oracle/optics.h"

#include "oracle/quad.h"

namespace dioptre
{
namespace
{

// The plane of incidence: `in` points to the side that the light goes to, `along` lies in the surface, both
// unit.
struct IncidencePlane {
    QuadVec in, along;
    Quad angle_rad; // of incidence, 0 to pi/2
};

IncidencePlane incidencePlane(const glm::dvec3& direction, const glm::dvec3& normal)
{
    const QuadVec d = quadFrom(direction);
    const QuadVec n = quadFrom(normal);
    const QuadVec in = (dot(d, n) < 0 ? -1 : 1) * unit(n);
    const QuadVec inSurface = d - dot(d, in) * in;
    const bool headOn = dot(inSurface, inSurface) == 0;
    return {in, headOn ? QuadVec{0, 0, 0} : unit(inSurface), angleBetween_rad(d, in)};
}

glm::dvec3 directionAt(const IncidencePlane& plane, Quad angle_rad)
{
    return doubleFrom(cosq(angle_rad) * plane.in + sinq(angle_rad) * plane.along);
}

Quad square(Quad x)
{
    return x * x;
}

} // namespace

FresnelShares fresnelShares(double cosIncidence, double index)
{
    if (index == 1.0)
        return {0.0, 1.0};
    const Quad n = index;
    if (cosIncidence == 1.0) { // where the laws below are 0 / 0
        return {static_cast<double>(square((n - 1) / (n + 1))), static_cast<double>(4 * n / square(n + 1))};
    }
    const Quad i = acosq(cosIncidence);
    const Quad sineRefracted = sinq(i) / n;
    if (sineRefracted >= 1)
        return {1.0, 0.0};
    const Quad r = asinq(sineRefracted);
    const Quad perpendicular = square(sinq(i - r) / sinq(i + r));
    const Quad parallel = square(tanq(i - r) / tanq(i + r));
    const Quad passed = sinq(2 * i) * sinq(2 * r) / square(sinq(i + r));
    const Quad passedParallel = passed / square(cosq(i - r));
    return {static_cast<double>((perpendicular + parallel) / 2),
            static_cast<double>((passed + passedParallel) / 2)};
}

std::optional<glm::dvec3> snellDirection(const glm::dvec3& direction, const glm::dvec3& normal, double index)
{
    const IncidencePlane plane = incidencePlane(direction, normal);
    const Quad sineRefracted = sinq(plane.angle_rad) / static_cast<Quad>(index);
    if (sineRefracted >= 1)
        return std::nullopt;
    return directionAt(plane, asinq(sineRefracted));
}

glm::dvec3 mirroredDirection(const glm::dvec3& direction, const glm::dvec3& normal)
{
    const IncidencePlane plane = incidencePlane(direction, normal);
    const QuadVec back = cosq(plane.angle_rad) * plane.in;
    return doubleFrom(sinq(plane.angle_rad) * plane.along - back);
}

} // namespace dioptre
