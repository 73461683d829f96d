#include "stability/aim.h"
#include "stability/case_rows.h"

#include <array>
#include <cmath>

namespace dioptre
{
namespace sphere_topic
{
namespace
{

using Problems = std::vector<RayProblem>;

RayProblem sphere(const glm::dvec3& centre, double radius)
{
    RayProblem problem;
    problem.primitive = shapeSphere;
    setPart(problem, 0, asFloat(centre));
    problem.p[3] = asFloat(radius);
    return problem;
}

// From `distance` away, at an impact parameter uniform up to 1.2 radii: five of six rays hit.
void aimAround(RandomFloats& random, RayProblem& problem, double distance)
{
    const glm::dvec3 centre = partOf(problem, 0);
    const glm::dvec3 origin = asFloat(centre + distance * random.direction());
    const glm::dvec3 aside = random.across(centre - origin);
    aim(problem, origin, passingPoint(origin, centre, aside, random.within(0.0, 1.2) * problem.p[3]));
}

void generic(RandomFloats& random, Problems& problems)
{
    const double radius = random.decades(-1, 1);
    RayProblem problem = sphere(random.inCube(10.0 * radius), radius);
    aimAround(random, problem, radius * random.within(1.5, 30.0));
    problems.push_back(problem);
}

void far(RandomFloats& random, Problems& problems)
{
    const double radius = random.decades(-1, 1);
    RayProblem problem = sphere(random.inCube(radius), radius);
    aimAround(random, problem, 1e4 * radius);
    problems.push_back(problem);
}

void tiny(RandomFloats& random, Problems& problems)
{
    RayProblem problem = sphere(random.inCube(1.0), 1e-4);
    aimAround(random, problem, 1e3);
    problems.push_back(problem);
}

void distant(RandomFloats& random, Problems& problems)
{
    RayProblem problem = sphere(random.inCube(100.0), 100.0);
    aimAround(random, problem, 1e7);
    problems.push_back(problem);
}

void planet(RandomFloats& random, Problems& problems)
{
    RayProblem problem = sphere({0.0, -1e7, 0.0}, 1e7);
    aimOverGround(random, problem, -4);
    problems.push_back(problem);
}

void offset(RandomFloats& random, Problems& problems)
{
    const double radius = random.within(0.5, 5.0);
    RayProblem problem = sphere(1e6 * random.direction(), radius);
    aimAround(random, problem, radius * random.within(2.0, 20.0));
    problems.push_back(problem);
}

double impactOf(const RayProblem& problem)
{
    const glm::dvec3 offset = problem.origin - partOf(problem, 0);
    const glm::dvec3 across = glm::cross(offset, unitOf(problem.direction));
    return std::sqrt(glm::dot(across, across));
}

void grazing(RandomFloats& random, Problems& problems)
{
    const double wanted = random.signedDecades(-8, -2); // once: the finest are the hardest to draw
    for (;;) {
        const double radius = random.decades(-1, 1);
        RayProblem problem = sphere(random.inCube(radius), radius);
        const glm::dvec3 centre = partOf(problem, 0);
        const glm::dvec3 origin = asFloat(centre + random.away(2.0 * radius, 20.0 * radius));
        const glm::dvec3 aside = random.across(centre - origin);
        aim(problem, origin, passingPoint(origin, centre, aside, (1.0 + wanted) * problem.p[3]));
        if (grazesAsWanted(impactOf(problem) / problem.p[3] - 1.0, wanted)) {
            problems.push_back(problem);
            return;
        }
    }
}

void inside(RandomFloats& random, Problems& problems)
{
    const double radius = random.decades(-2, 2);
    RayProblem problem = sphere(random.inCube(10.0 * radius), radius);
    problem.origin = asFloat(partOf(problem, 0) + random.away(0.0, 0.95 * radius));
    problem.direction = asFloat(random.direction());
    problems.push_back(problem);
}

void anyLength(RandomFloats& random, Problems& problems)
{
    generic(random, problems);
    RayProblem& problem = problems.back();
    problem.direction = asFloat(random.decades(-3, 3) * problem.direction);
}

void justAbove(RandomFloats& random, Problems& problems)
{
    for (;;) {
        const double radius = random.decades(-1, 1);
        RayProblem problem = sphere(random.inCube(radius), radius);
        const glm::dvec3 centre = partOf(problem, 0);
        const glm::dvec3 out = random.direction();
        const glm::dvec3 origin = asFloat(centre + problem.p[3] * (1.0 + random.decades(-6, -2)) * out);
        // At any point within, now and then straight away from it.
        const glm::dvec3 target = centre + 0.9 * problem.p[3] * random.direction();
        aim(problem, origin, random.chance(0.9) ? target : 2.0 * origin - target);
        const glm::dvec3 from = origin - centre;
        const double above = std::sqrt(glm::dot(from, from)) / problem.p[3] - 1.0;
        if (above >= 1e-6 && above <= 1e-2) {
            problems.push_back(problem);
            return;
        }
    }
}

void bead(RandomFloats& random, Problems& problems)
{
    RayProblem problem = sphere(random.inCube(1.0), 1e-3);
    aimAround(random, problem, 2.0);
    problems.push_back(problem);
}

const std::array rows{
    CaseRow{"S01", "a sphere, generic", false, {.k = 8.0, .flipsOverMargin = 0.0}, generic},
    CaseRow{"S02", "a sphere 1e4 radii away", false, {.normal_rad = 1e-6, .flips = 0.0}, far},
    CaseRow{"S03", "a sphere of 0.1 mm, 1 km away", false, {.flips = 0.0}, tiny},
    CaseRow{"S04", "a sphere of 100 m, 1e7 m away", false, {.normal_rad = 1e-6, .flips = 0.0}, distant},
    CaseRow{"S05", "a planet of 1e7 m, the eye near it", false, {.relativeT = 1e-6, .flips = 0.0}, planet},
    CaseRow{"S06", "a sphere in a scene 1e6 m from the origin", false, {.normal_rad = 1e-6}, offset},
    CaseRow{"S07",
            "a sphere grazed at 1 +- 1e-8..1e-2 radii",
            false,
            {.relativeT = 1e-6, .normal_rad = 1e-6, .flips = 0.0},
            grazing},
    CaseRow{"S08", "a sphere from inside", true, {.flips = 0.0}, inside},
    CaseRow{"S10", "a sphere, the direction not unit", false, {.relativeT = 1e-6}, anyLength},
    CaseRow{"S11", "a sphere from 1e-6..1e-2 radii above it", false, {.relativeT = 1e-6}, justAbove},
    CaseRow{"S13", "a bead of 1 mm, 2 m away", false, {.normal_rad = 1e-6, .flips = 0.0}, bead},
};

} // namespace
} // namespace sphere_topic

std::span<const CaseRow> sphereCases()
{
    return sphere_topic::rows;
}

} // namespace dioptre
