#include "stability/aim.h"
#include "stability/case_rows.h"

#include <array>
#include <cmath>

namespace dioptre
{
namespace flat_topic
{
namespace
{

using Problems = std::vector<RayProblem>;

// A flat shape's part: a point and a unit normal, or a corner and two edges.
RayProblem flat(int primitive, const glm::dvec3& first, const glm::dvec3& second, const glm::dvec3& third)
{
    RayProblem problem;
    problem.primitive = primitive;
    setPart(problem, 0, asFloat(first));
    setPart(problem, 3, asFloat(second));
    setPart(problem, 6, asFloat(third));
    return problem;
}

RayProblem disk(const glm::dvec3& centre, const glm::dvec3& normal, double radius)
{
    return flat(shapeDisk, centre, normal, {radius, 0.0, 0.0});
}

// Towards `target` from 1 to 30 lengths away, one of five turned round.
void aimFromAnywhere(RandomFloats& random, RayProblem& problem, const glm::dvec3& target, double length)
{
    const glm::dvec3 origin = asFloat(target + random.away(length, 30.0 * length));
    aim(problem, origin, random.chance(0.8) ? target : 2.0 * origin - target);
}

void plane(RandomFloats& random, Problems& problems)
{
    const glm::dvec3 point = random.inCube(10.0);
    const glm::dvec3 normal = random.direction();
    RayProblem problem = flat(shapePlane, point, normal, glm::dvec3(0.0));
    aimFromAnywhere(random, problem, point + random.aside(normal, 0.0, 5.0), 1.0);
    problems.push_back(problem);
}

void disks(RandomFloats& random, Problems& problems)
{
    const double radius = random.decades(-1, 1);
    const glm::dvec3 centre = random.inCube(10.0 * radius);
    const glm::dvec3 normal = random.direction();
    RayProblem problem = disk(centre, normal, radius);
    aimFromAnywhere(random, problem, centre + random.aside(normal, 0.0, 1.2 * radius), radius);
    problems.push_back(problem);
}

// Corner and two edges of like length, 30 degrees apart at least, and one place: shares of the edges in
// -0.1..1.1.
struct Corner {
    double size;
    glm::dvec3 corner, u, v, place;
};

Corner corner(RandomFloats& random, double size)
{
    Corner made{};
    made.size = size;
    made.corner = random.inCube(10.0 * size);
    made.u = random.away(0.5 * size, size);
    made.v = random.aside(made.u, 0.5 * size, size);
    made.v += random.within(-0.8, 0.8) * made.u;
    made.place = made.corner + random.within(-0.1, 1.1) * made.u;
    made.place += random.within(-0.1, 1.1) * made.v;
    return made;
}

void rectangle(RandomFloats& random, Problems& problems)
{
    const Corner made = corner(random, random.decades(-1, 1));
    RayProblem problem = flat(shapeRectangle, made.corner, made.u, made.v);
    aimFromAnywhere(random, problem, made.place, made.size);
    problems.push_back(problem);
}

void triangle(RandomFloats& random, Problems& problems)
{
    const Corner made = corner(random, random.decades(-1, 1));
    RayProblem problem = flat(shapeTriangle, made.corner, made.corner + made.u, made.corner + made.v);
    aimFromAnywhere(random, problem, made.place, made.size);
    problems.push_back(problem);
}

// Runs down onto the plane at an angle of 0.5e-6 to 2e-6 rad, from a hundredth to a tenth of a metre above
// it.
void grazedPlane(RandomFloats& random, Problems& problems)
{
    for (;;) {
        const glm::dvec3 point = random.inCube(10.0);
        RayProblem problem = flat(shapePlane, point, random.direction(), glm::dvec3(0.0));
        const glm::dvec3 normal = partOf(problem, 3);
        const double height = random.decades(-2, -1);
        const glm::dvec3 above = height * normal + random.aside(normal, 0.0, 10.0);
        problem.origin = asFloat(partOf(problem, 0) + above);
        problem.direction = asFloat(unitOf(random.across(normal) - 1e-6 * normal));
        const double fall = -glm::dot(problem.direction, normal);
        if (fall > 0.5e-6 && fall < 2e-6) {
            problems.push_back(problem);
            return;
        }
    }
}

// From 1 to 100 m above it to anywhere on it and somewhat beyond.
void hugeDisk(RandomFloats& random, Problems& problems)
{
    for (;;) {
        const glm::dvec3 centre = random.inCube(100.0);
        RayProblem problem = disk(centre, random.direction(), 1e6);
        const glm::dvec3 normal = partOf(problem, 3);
        const double height = random.decades(0, 2);
        const glm::dvec3 origin =
            asFloat(partOf(problem, 0) + height * normal + random.aside(normal, 0.0, 1e6));
        aim(problem, origin, partOf(problem, 0) + random.aside(normal, 0.0, 1.2e6));
        if (glm::dot(origin - partOf(problem, 0), normal) >= 1.0) { // after rounding
            problems.push_back(problem);
            return;
        }
    }
}

// A point of the triangle a, b, c, or just outside by a tenth.
glm::dvec3 placeOn(RandomFloats& random, const RayProblem& problem)
{
    const glm::dvec3 a = partOf(problem, 0);
    const double u = random.within(-0.1, 1.1);
    const double v = random.within(-0.1, 1.1 - u);
    return a + u * (partOf(problem, 3) - a) + v * (partOf(problem, 6) - a);
}

glm::dvec3 normalOf(const RayProblem& triangle)
{
    const glm::dvec3 a = partOf(triangle, 0);
    return unitOf(glm::cross(partOf(triangle, 3) - a, partOf(triangle, 6) - a));
}

// 1 long, 1e-5 high, seen from 2 to 10 away at no grazing angle.
void needle(RandomFloats& random, Problems& problems)
{
    const glm::dvec3 a = random.inCube(1.0);
    const glm::dvec3 along = random.direction();
    const double foot = random.within(0.2, 0.8);
    RayProblem problem = flat(shapeTriangle, a, a + along, a + foot * along + 1e-5 * random.across(along));
    const glm::dvec3 target = placeOn(random, problem);
    glm::dvec3 towardsEye = random.direction();
    while (std::abs(glm::dot(towardsEye, normalOf(problem))) < 0.2)
        towardsEye = random.direction();
    aim(problem, target + random.within(2.0, 10.0) * towardsEye, target);
    problems.push_back(problem);
}

// Met at 1e-3 to 1e-2 rad.
void grazedTriangle(RandomFloats& random, Problems& problems)
{
    const Corner made = corner(random, 1.0);
    RayProblem problem = flat(shapeTriangle, made.corner, made.corner + made.u, made.corner + made.v);
    const glm::dvec3 normal = normalOf(problem);
    const glm::dvec3 target = placeOn(random, problem);
    const double slope = random.decades(-3, -2);
    const glm::dvec3 towardsEye = unitOf(random.across(normal) + slope * normal);
    aim(problem, target + random.within(2.0, 5.0) * towardsEye, target);
    problems.push_back(problem);
}

// In a scene of its own size, from half a metre to two away.
void tinyTriangle(RandomFloats& random, Problems& problems)
{
    const Corner made = corner(random, 1e-4);
    RayProblem problem = flat(shapeTriangle, made.corner, made.corner + made.u, made.corner + made.v);
    const glm::dvec3 target = placeOn(random, problem);
    aim(problem, target + random.away(0.5, 2.0), target);
    problems.push_back(problem);
}

const Gate genericGate{.k = 8.0, .flipsOverMargin = 0.0};

const std::array rows{
    CaseRow{"P01", "a plane, generic", true, genericGate, plane},
    CaseRow{"P02", "a plane at 1e-6 rad", false, {.relativeT = 1e-6}, grazedPlane},
    CaseRow{"D01", "a disk, generic", true, genericGate, disks},
    CaseRow{"D02", "a disk of 1e6 m, the eye near it", false, {.relativeT = 1e-6}, hugeDisk},
    CaseRow{"R01", "a parallelogram, generic", true, genericGate, rectangle},
    CaseRow{"T01", "a triangle, generic", true, genericGate, triangle},
    CaseRow{"T02", "a needle of a triangle, 1e-5 high", false, {.relativeT_p999 = 1e-6}, needle},
    CaseRow{"T06", "a triangle at 1e-3..1e-2 rad", false, {.relativeT_p999 = 1e-6}, grazedTriangle},
    CaseRow{"T08", "a triangle of 0.1 mm", false, {.flipsOverMargin = 0.0}, tinyTriangle},
};

} // namespace
} // namespace flat_topic

std::span<const CaseRow> flatCases()
{
    return flat_topic::rows;
}

} // namespace dioptre
