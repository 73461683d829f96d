#include "stability/aim.h"
#include "stability/case_rows.h"

#include <array>
#include <cmath>

namespace dioptre
{
namespace cylinder_topic
{
namespace
{

using Problems = std::vector<RayProblem>;

RayProblem cylinder(int primitive, const glm::dvec3& base, const glm::dvec3& axis, double radius)
{
    RayProblem problem;
    problem.primitive = primitive;
    setPart(problem, 0, asFloat(base));
    setPart(problem, 3, asFloat(axis));
    problem.p[6] = asFloat(radius);
    return problem;
}

int eitherKind(RandomFloats& random)
{
    return random.chance(0.5) ? shapeOpenCylinder : shapeCappedCylinder;
}

// At a height `z` (0 base, 1 top) past the axis at the distance `impact` (signed), where the eye is further
// off than that; else at the axis.
void aimBeside(RayProblem& problem, const glm::dvec3& origin, double z, double impact)
{
    const glm::dvec3 axis = partOf(problem, 3);
    const glm::dvec3 up = unitOf(axis);
    const glm::dvec3 foot = partOf(problem, 0) + z * axis;
    const glm::dvec3 off = origin - foot;
    const glm::dvec3 sideways = off - glm::dot(off, up) * up;
    if (glm::dot(sideways, sideways) <= 1.01 * impact * impact)
        return aim(problem, origin, foot);
    const glm::dvec3 aside = unitOf(glm::cross(up, sideways));
    aim(problem, origin,
        passingPoint(foot + sideways, foot, impact < 0.0 ? -aside : aside, std::abs(impact)));
}

// From `distance` away from its middle, up to 1.2 radii past the axis and a tenth of the height past its
// ends.
void aimAround(RandomFloats& random, RayProblem& problem, double distance)
{
    const glm::dvec3 middle = partOf(problem, 0) + 0.5 * partOf(problem, 3);
    const glm::dvec3 origin = asFloat(middle + distance * random.direction());
    const double z = random.within(-0.1, 1.1);
    aimBeside(problem, origin, z, random.within(-1.2, 1.2) * problem.p[6]);
}

RayProblem genericCylinder(RandomFloats& random, int primitive)
{
    const double radius = random.decades(-1, 1);
    const glm::dvec3 base = random.inCube(10.0 * radius);
    const double height = radius * random.within(0.5, 6.0);
    return cylinder(primitive, base, height * random.direction(), radius);
}

void seen(RandomFloats& random, Problems& problems, int primitive)
{
    RayProblem problem = genericCylinder(random, primitive);
    aimAround(random, problem, problem.p[6] * random.within(5.0, 40.0));
    problems.push_back(problem);
}

void open(RandomFloats& random, Problems& problems)
{
    seen(random, problems, shapeOpenCylinder);
}

void capped(RandomFloats& random, Problems& problems)
{
    seen(random, problems, shapeCappedCylinder);
}

// From beyond the top, 1e-6 to 1e-3 rad off the axis.
void nearParallel(RandomFloats& random, Problems& problems)
{
    RayProblem problem = genericCylinder(random, eitherKind(random));
    const glm::dvec3 axis = partOf(problem, 3);
    const glm::dvec3 beside = random.aside(axis, 0.0, 1.2 * problem.p[6]);
    const double slope = random.decades(-6, -3);
    problem.origin = asFloat(partOf(problem, 0) + random.within(1.1, 4.0) * axis + beside);
    problem.direction = asFloat(unitOf(slope * random.across(axis) - unitOf(axis)));
    problems.push_back(problem);
}

void thin(RandomFloats& random, Problems& problems)
{
    const int primitive = eitherKind(random);
    const glm::dvec3 base = random.inCube(1.0);
    RayProblem problem = cylinder(primitive, base, 100.0 * random.direction(), 1e-3);
    aimAround(random, problem, random.within(60.0, 500.0));
    problems.push_back(problem);
}

void far(RandomFloats& random, Problems& problems)
{
    RayProblem problem = genericCylinder(random, eitherKind(random));
    aimAround(random, problem, 1e5 * problem.p[6]);
    problems.push_back(problem);
}

double impactOf(const RayProblem& problem)
{
    const glm::dvec3 across = unitOf(glm::cross(problem.direction, partOf(problem, 3)));
    return std::abs(glm::dot(problem.origin - partOf(problem, 0), across));
}

void grazing(RandomFloats& random, Problems& problems)
{
    const double wanted = random.signedDecades(-8, -2); // once: the finest are the hardest to draw
    for (;;) {
        RayProblem problem = genericCylinder(random, eitherKind(random));
        const glm::dvec3 middle = partOf(problem, 0) + 0.5 * partOf(problem, 3);
        const glm::dvec3 origin = asFloat(middle + random.away(8.0 * problem.p[6], 30.0 * problem.p[6]));
        const double z = random.within(0.05, 0.95);
        aimBeside(problem, origin, z, random.sign() * (1.0 + wanted) * problem.p[6]);
        if (grazesAsWanted(impactOf(problem) / problem.p[6] - 1.0, wanted)) {
            problems.push_back(problem);
            return;
        }
    }
}

// In through the opening, well within its rim, and onto the wall, well below it.
void throughTheEnd(RandomFloats& random, Problems& problems)
{
    RayProblem problem = genericCylinder(random, shapeOpenCylinder);
    const glm::dvec3 base = partOf(problem, 0);
    const glm::dvec3 axis = partOf(problem, 3);
    const glm::dvec3 opening = base + axis + random.aside(axis, 0.0, 0.9 * problem.p[6]);
    const double z = random.within(0.05, 0.9);
    const glm::dvec3 wall = base + z * axis + problem.p[6] * random.across(axis);
    aim(problem, opening + random.within(0.5, 5.0) * (opening - wall), wall);
    problems.push_back(problem);
}

// It lies along the ground, below it.
void huge(RandomFloats& random, Problems& problems)
{
    RayProblem problem = cylinder(eitherKind(random), {0.0, -1e6, -1e6}, {0.0, 0.0, 2e6}, 1e6);
    aimOverGround(random, problem, -3);
    problems.push_back(problem);
}

const Gate genericGate{.k = 8.0, .flipsOverMargin = 0.0};

const std::array rows{
    CaseRow{"C01", "an open cylinder, generic", false, genericGate, open},
    CaseRow{"C02", "a capped cylinder, generic", false, genericGate, capped},
    CaseRow{"C03", "a cylinder, 1e-6..1e-3 rad off its axis", true, {.flipsOverMargin = 0.0}, nearParallel},
    CaseRow{"C04", "a cylinder 1e5 times as long as thick", false, {.flipsOverMargin = 0.0}, thin},
    CaseRow{"C05", "a cylinder 1e5 radii away", false, {.flipsOverMargin = 0.0}, far},
    CaseRow{"C06", "a cylinder grazed at 1 +- 1e-8..1e-2 radii", false, {.flipsOverMargin = 0.0}, grazing},
    CaseRow{"C07", "an open cylinder through its end", true, {.flips = 0.0}, throughTheEnd},
    CaseRow{"C08", "a cylinder of 1e6 m, the eye near it", false, {.relativeT = 1e-6}, huge},
};

} // namespace
} // namespace cylinder_topic

std::span<const CaseRow> cylinderCases()
{
    return cylinder_topic::rows;
}

} // namespace dioptre
