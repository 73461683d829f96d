// Edges that triangles share, shapes that are none, and rays that start on a surface.
#include "stability/aim.h"
#include "stability/case_rows.h"

#include <array>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace surface_topic
{
namespace
{

using Problems = std::vector<RayProblem>;
constexpr int fan = 6; // triangles about a vertex

// The ends of the spokes of a hilly fan about `hub`, 60 degrees apart as seen along the normal.
std::array<glm::dvec3, fan> spokeEnds(RandomFloats& random, const glm::dvec3& hub, const glm::dvec3& normal)
{
    const glm::dvec3 x = random.across(normal);
    const glm::dvec3 y = glm::cross(normal, x);
    const double sine = std::sqrt(0.75);
    const std::array<glm::dvec2, fan> turns{
        {{1.0, 0.0}, {0.5, sine}, {-0.5, sine}, {-1.0, 0.0}, {-0.5, -sine}, {0.5, -sine}}};
    std::array<glm::dvec3, fan> ends{};
    for (std::size_t i = 0; i < fan; ++i) {
        const double length = random.within(0.5, 1.5);
        const double relief = random.within(-0.1, 0.1);
        ends[i] = asFloat(hub + length * (turns[i].x * x + turns[i].y * y) + relief * normal);
    }
    return ends;
}

// At a spoke, or for one ray of five at the hub, from in front: one triangle of the six is hit at least.
void sharedEdges(RandomFloats& random, Problems& problems)
{
    const glm::dvec3 hub = asFloat(random.inCube(1.0));
    const glm::dvec3 normal = random.direction();
    const auto ends = spokeEnds(random, hub, normal);
    const glm::dvec3 towardsEye = unitOf(normal + random.aside(normal, 0.0, 0.3));
    const auto spoke = static_cast<std::size_t>(random.below(fan));
    const double along = random.chance(0.2) ? 0.0 : random.within(0.05, 0.9);
    const glm::dvec3 target = hub + along * (ends[spoke] - hub);
    RayProblem ray;
    ray.primitive = shapeTriangle;
    aim(ray, target + random.within(2.0, 10.0) * towardsEye, target);
    for (std::size_t i = 0; i < fan; ++i) {
        // The corners begin anywhere, so that neighbours hold their edge in different places.
        const std::array<glm::dvec3, 3> corners{hub, ends[i], ends[(i + 1) % fan]};
        const auto first = static_cast<std::size_t>(random.below(3));
        for (std::size_t k = 0; k < 3; ++k)
            setPart(ray, 3 * k, corners[(first + k) % 3]);
        problems.push_back(ray);
    }
}

// Of any kind, in front of the ray, which it hits.
RayProblem sound(RandomFloats& random)
{
    RayProblem problem;
    problem.primitive = random.below(shapeTriangle + 1);
    const glm::dvec3 place = asFloat(random.inCube(1.0));
    const glm::dvec3 normal = random.direction();
    const glm::dvec3 across = random.across(normal);
    setPart(problem, 0, place);
    setPart(problem, 3, asFloat(normal));
    if (problem.primitive == shapeSphere)
        setPart(problem, 3, {1.0, 0.0, 0.0});
    else if (problem.primitive == shapeRectangle)
        setPart(problem, 6, asFloat(across));
    else if (problem.primitive == shapeTriangle) {
        setPart(problem, 3, asFloat(place + normal));
        setPart(problem, 6, asFloat(place + across));
    } else if (problem.primitive != shapePlane)
        problem.p[6] = 1.0;
    aim(problem, place + random.away(3.0, 5.0), place);
    return problem;
}

// How many of p[] the kind reads.
std::size_t numbersOf(int primitive)
{
    static constexpr std::array<std::size_t, 7> counts{4, 7, 7, 6, 7, 9, 9};
    return counts[static_cast<std::size_t>(primitive)];
}

// No extent: radius 0 or below, no axis, normal or second corner; edges on one line.
void flatten(RandomFloats& random, RayProblem& problem)
{
    const double radius = random.chance(0.5) ? 0.0 : -1.0;
    switch (problem.primitive) {
    case shapeSphere:
        problem.p[3] = radius;
        break;
    case shapePlane:
        setPart(problem, 3, glm::dvec3(0.0));
        break;
    case shapeRectangle:
        setPart(problem, 6, random.chance(0.5) ? glm::dvec3(0.0) : 2.0 * partOf(problem, 3));
        break;
    case shapeTriangle: { // whole numbers: on one line in float as well
        const glm::dvec3 a(random.below(5));
        setPart(problem, 0, a);
        setPart(problem, 3, a + glm::dvec3(1.0, 2.0, -1.0));
        setPart(problem, 6, a + glm::dvec3(3.0, 6.0, -3.0));
        break;
    }
    default:
        if (random.chance(0.5))
            problem.p[6] = radius;
        else
            setPart(problem, 3, glm::dvec3(0.0));
    }
}

// The ray exactly along the flat shape above it, or along the cylinder's axis beside it; not for a sphere.
void makeParallel(RandomFloats& random, RayProblem& problem)
{
    const glm::dvec3 place = partOf(problem, 0);
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const bool cylinder = problem.primitive <= shapeCappedCylinder;
    setPart(problem, 3, up);
    if (problem.primitive == shapeRectangle || problem.primitive == shapeTriangle) {
        const glm::dvec3 from = problem.primitive == shapeTriangle ? place : glm::dvec3(0.0);
        setPart(problem, 3, asFloat(from + glm::dvec3(1.0, 0.0, 0.0)));
        setPart(problem, 6, asFloat(from + glm::dvec3(0.0, 0.0, 1.0)));
    }
    const glm::dvec3 level = random.across(up);
    problem.origin = asFloat(place + (cylinder ? 1.5 * level + 3.0 * up : up - 3.0 * level));
    problem.direction = cylinder ? -up : asFloat(glm::dvec3(level.x, 0.0, level.z));
}

void degenerate(RandomFloats& random, Problems& problems)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    RayProblem problem = sound(random);
    const int fault = random.below(4);
    if (fault == 0 || (fault == 1 && problem.primitive == shapeSphere)) {
        flatten(random, problem);
    } else if (fault == 1) {
        makeParallel(random, problem);
    } else {
        const double bad = random.chance(0.5) ? nan : random.sign() * inf;
        if (fault == 2) {
            const int place = random.below(static_cast<int>(numbersOf(problem.primitive)));
            problem.p[static_cast<std::size_t>(place)] = bad;
        } else {
            glm::dvec3& broken = random.chance(0.5) ? problem.origin : problem.direction;
            broken[random.below(3)] = bad;
        }
    }
    problems.push_back(problem);
}

// From a sphere or the wall of a cylinder, to either side at 6 degrees or more from the surface. Far from the
// world's origin only what is large enough for floats to place a point on it.
void leaving(RandomFloats& random, Problems& problems)
{
    const bool offset = random.chance(0.3);
    const double radius = asFloat(random.decades(offset ? 2 : -3, 7));
    RayProblem problem;
    problem.primitive = random.below(shapeCappedCylinder + 1);
    const glm::dvec3 place = asFloat(offset ? 1e6 * random.direction() : glm::dvec3(0.0));
    setPart(problem, 0, place);
    glm::dvec3 normal = random.direction();
    if (problem.primitive == shapeSphere) {
        problem.p[3] = radius;
        problem.origin = asFloat(place + radius * normal);
    } else {
        const glm::dvec3 axis = asFloat(random.away(radius, 4.0 * radius));
        setPart(problem, 3, axis);
        problem.p[6] = radius;
        normal = random.across(axis);
        problem.origin = asFloat(place + random.within(0.1, 0.9) * axis + radius * normal);
    }
    do
        problem.direction = asFloat(random.direction());
    while (std::abs(glm::dot(problem.direction, normal)) < 0.1);
    problem.spawn = true;
    problems.push_back(problem);
}

// From a surface onto another 1e-6 to 4e-6 of its radius away.
void neighbour(RandomFloats& random, Problems& problems)
{
    for (;;) {
        const double radius = random.decades(-3, 7);
        RayProblem problem;
        setPart(problem, 0, asFloat(random.inCube(0.5 * radius)));
        problem.p[3] = asFloat(radius);
        const glm::dvec3 centre = partOf(problem, 0);
        const glm::dvec3 normal = random.direction();
        problem.origin = asFloat(centre + problem.p[3] * (1.0 + random.within(1e-6, 4e-6)) * normal);
        problem.direction = asFloat(random.direction());
        const glm::dvec3 from = problem.origin - centre;
        const double above = std::sqrt(glm::dot(from, from)) / problem.p[3] - 1.0;
        if (glm::dot(problem.direction, normal) < -0.1 && above >= 1e-6 && above <= 4e-6) {
            problems.push_back(problem);
            return;
        }
    }
}

const std::array rows{
    CaseRow{"edges",
            "rays at the edges and corners that triangles share",
            false,
            {.leaks = 0.0},
            sharedEdges,
            fan},
    CaseRow{"degenerate", "no extent, exactly parallel, NaN or infinite", false, {.flips = 0.0}, degenerate},
    // Half the way to the far side or less is the surface itself, met again.
    CaseRow{"leaving",
            "rays that leave a surface, 1 mm..1e7 m",
            false,
            {.relativeT = 0.5, .flipsOverMargin = 0.0},
            leaving},
    CaseRow{"neighbour",
            "a surface 1e-6 radii from the one left",
            false,
            {.relativeT = 1e-6, .flips = 0.0},
            neighbour},
};

} // namespace
} // namespace surface_topic

std::span<const CaseRow> surfaceCases()
{
    return surface_topic::rows;
}

} // namespace dioptre
