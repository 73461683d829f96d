// How far a line passes from what bounds a shape: by construction, against a dense scan, and by shifting the
// line.
#include "problems.h"
#include "randoms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

// The margin back in metres.
double passes_m(const RayProblem& problem)
{
    return solve(problem).margin * 0x1p-24 * extentOf(problem);
}

// A shape of that kind about the origin and a ray from about 6 away that often meets it.
RayProblem randomProblem(Randoms& random, int primitive)
{
    RayProblem problem;
    problem.primitive = primitive;
    setPart(problem.p, 0, random.inCube(0.5));
    if (primitive == shapeSphere)
        problem.p[3] = random.within(0.2, 2.0);
    else
        setPart(problem.p, 3, random.inCube(2.0));
    setPart(problem.p, 6, random.inCube(2.0));
    if (primitive == shapeOpenCylinder || primitive == shapeCappedCylinder || primitive == shapeDisk)
        problem.p[6] = random.within(0.1, 2.0);
    problem.origin = random.inCube(1.0) + 6.0 * glm::normalize(random.inCube(1.0));
    problem.direction = random.within(0.1, 3.0) * (random.inCube(1.5) - problem.origin);
    return problem;
}

double lineToPoint(const RayProblem& problem, const glm::dvec3& point)
{
    return glm::length(glm::cross(point - problem.origin, glm::normalize(problem.direction)));
}

// The least distance of the line to points of a circle, spaced so that what lies between is nearer by less
// than 1e-6 R.
double scannedRim(const RayProblem& problem, const glm::dvec3& centre, const glm::dvec3& axis, double radius)
{
    const glm::dvec3 normal = glm::normalize(axis);
    const glm::dvec3 across = glm::normalize(
        glm::cross(normal, std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 other = glm::cross(normal, across);
    double least = std::numeric_limits<double>::infinity();
    constexpr int points = 20000;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::acos(-1.0) * i / points;
        least = std::min(least, lineToPoint(problem, centre + radius * (std::cos(angle) * across +
                                                                        std::sin(angle) * other)));
    }
    return least;
}

} // namespace

TEST(Oracle_Margin, OfASphere_IsTheLinesDistanceToItsSilhouette)
{
    const std::array<double, 9> ball{0, 0, 0, 5};
    EXPECT_DOUBLE_EQ(passes_m(problemOf(0, ball, {-20, 3, 0}, {7, 0, 0})), 2.0);
    EXPECT_DOUBLE_EQ(passes_m(problemOf(0, ball, {-20, 9, 0}, {1, 0, 0})), 4.0);
    EXPECT_EQ(passes_m(problemOf(0, ball, {-20, 5, 0}, {1, 0, 0})), 0.0);
    EXPECT_DOUBLE_EQ(passes_m(problemOf(0, ball, {-20, 5 - 0x1p-40, 0}, {1, 0, 0})), 0x1p-40);
}

TEST(Oracle_Margin, ItsUnit_IsFloatsRoundoffOfDistancePlusSize)
{
    EXPECT_EQ(solve(problemOf(0, {0, 0, 0, 5}, {-12, 4, 3}, {1, 0, 0})).margin, 0.0);
    EXPECT_DOUBLE_EQ(solve(problemOf(0, {0, 0, 0, 7}, {-12, 4, 3}, {1, 0, 0})).margin,
                     2.0 / (0x1p-24 * 20.0));
    EXPECT_DOUBLE_EQ(extentOf(problemOf(2, {0, 0, 0, 0, 10, 0, 5}, {3, 4, 0}, {1, 0, 0})), 20.0);
    EXPECT_DOUBLE_EQ(extentOf(problemOf(3, {0, 0, 0, 0, 10, 0}, {3, 4, 0}, {1, 0, 0})), 5.0);
    EXPECT_DOUBLE_EQ(extentOf(problemOf(4, {0, 0, 0, 0, 10, 0, 2}, {3, 4, 0}, {1, 0, 0})),
                     5.0 + 10.0 * 0.0 + 2.0);
    EXPECT_DOUBLE_EQ(extentOf(problemOf(5, {0, 0, 0, 3, 0, 0, 0, 2, 0}, {3, 4, 0}, {1, 0, 0})), 10.0);
    EXPECT_DOUBLE_EQ(extentOf(problemOf(6, {1, 0, 0, 4, 0, 0, 1, 2, 0}, {4, 4, 0}, {1, 0, 0})), 10.0);
}

TEST(Oracle_Margin, OfACylinder_IsTheNearerOfWallAndRims)
{
    const std::array<double, 9> pipe{0, 0, 0, 0, 10, 0, 5};
    for (const int kind : {shapeOpenCylinder, shapeCappedCylinder}) {
        EXPECT_DOUBLE_EQ(passes_m(problemOf(kind, pipe, {-20, 5, 3}, {1, 0, 0})),
                         2.0); // the wall's silhouette
        EXPECT_DOUBLE_EQ(passes_m(problemOf(kind, pipe, {-20, 9, 3}, {1, 0, 0})),
                         1.0); // the top rim, edge-on
        EXPECT_DOUBLE_EQ(passes_m(problemOf(kind, pipe, {-20, 13, 9}, {1, 0, 0})),
                         5.0); // its end: 3 up and 4 aside
        EXPECT_DOUBLE_EQ(passes_m(problemOf(kind, pipe, {1, 20, 0}, {0, -1, 0})),
                         4.0); // both rims, along the axis
    }
}

TEST(Oracle_Margin, OfFlatShapes_IsTheDistanceToTheirEdges)
{
    EXPECT_DOUBLE_EQ(passes_m(problemOf(4, {0, 0, 0, 0, 0, 2, 5}, {0, 3, 6}, {0, 0, -1})), 2.0);
    // Seen at 60 degrees a disk is half as wide; from its middle line its short axis' end is the nearest.
    EXPECT_NEAR(passes_m(problemOf(4, {0, 0, 0, std::sqrt(3.0), 0, 1, 4}, {1, 0, 9}, {0, 0, -1})), 1.0,
                1e-14);
    EXPECT_DOUBLE_EQ(passes_m(problemOf(5, {0, 0, 0, 4, 0, 0, 0, 3, 0}, {1.5, 2, 9}, {0, 0, -1})), 1.0);
    EXPECT_DOUBLE_EQ(passes_m(problemOf(5, {0, 0, 0, 4, 0, 0, 0, 3, 0}, {7, 7, 9}, {0, 0, -1})), 5.0);
    EXPECT_DOUBLE_EQ(passes_m(problemOf(6, {0, 0, 0, 4, 0, 0, 0, 3, 0}, {3, 3, 9}, {0, 0, -1})), 9.0 / 5.0);
    EXPECT_DOUBLE_EQ(passes_m(problemOf(6, {0, 0, 0, 4, 0, 0, 0, 3, 0}, {1, 1, 9}, {0, 0, -1})), 1.0);
}

TEST(Oracle_Margin, OfAPlane_IsNothingAlongItAndInfiniteElsewhere)
{
    EXPECT_EQ(solve(problemOf(3, {0, 0, 0, 0, 1, 0}, {0, 1, 0}, {1, -1e-30, 0})).margin,
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(solve(problemOf(3, {0, 0, 0, 0, 1, 0}, {0, 1, 0}, {1, 0, 0})).margin, 0.0);
}

TEST(Oracle_Margin, OfRims_AgreesWithADenseScan)
{
    Randoms random(31);
    for (int i = 0; i < 60; ++i) {
        const RayProblem disk = randomProblem(random, shapeDisk);
        const double scanned = scannedRim(disk, partOf(disk.p, 0), partOf(disk.p, 3), disk.p[6]);
        EXPECT_NEAR(passes_m(disk), scanned, 1e-3 * disk.p[6]) << "problem " << i;
    }
    for (int i = 0; i < 60; ++i) {
        const RayProblem pipe = randomProblem(random, shapeCappedCylinder);
        const glm::dvec3 base = partOf(pipe.p, 0);
        const glm::dvec3 axis = partOf(pipe.p, 3);
        const glm::dvec3 across = glm::cross(axis, pipe.direction);
        const glm::dvec3 aside = pipe.p[6] * glm::normalize(across);
        double scanned =
            std::min(scannedRim(pipe, base, axis, pipe.p[6]), scannedRim(pipe, base + axis, axis, pipe.p[6]));
        for (int step = 0; step <= 10000; ++step) // along the wall's silhouette
            for (const double side : {-1.0, 1.0})
                scanned = std::min(scanned, lineToPoint(pipe, base + 1e-4 * step * axis + side * aside));
        EXPECT_NEAR(passes_m(pipe), scanned, 1e-3 * (pipe.p[6] + glm::length(axis))) << "problem " << i;
    }
}

// What the margin is for: within it rounding cannot turn a hit into a miss, beyond it some shift does. Not
// always one of 128: a sharp corner or a disk nearly edge-on is missed by them, and a capped cylinder's front
// rim only tells cap from wall.
TEST(Oracle_Margin, AShiftOfTheLine_ChangesHitAndMissBeyondIt_AndNeverWithinIt)
{
    Randoms random(32);
    for (const int kind : {shapeSphere, shapeCappedCylinder, shapeDisk, shapeRectangle, shapeTriangle}) {
        int changing = 0;
        for (int i = 0; i < 40; ++i) {
            const RayProblem problem = randomProblem(random, kind);
            const bool hit = solve(problem).hit;
            const double metres = passes_m(problem);
            const glm::dvec3 forwards = glm::normalize(problem.direction);
            const glm::dvec3 across = glm::normalize(glm::cross(forwards, random.inCube(1.0)));
            bool changes = false;
            for (int turn = 0; turn < 128; ++turn) {
                const double angle = std::acos(-1.0) * turn / 64.0;
                const glm::dvec3 aside =
                    std::cos(angle) * across + std::sin(angle) * glm::cross(forwards, across);
                RayProblem shifted = problem;
                shifted.origin += 0.999 * metres * aside;
                EXPECT_EQ(solve(shifted).hit, hit) << "kind " << kind << ", problem " << i;
                shifted.origin = problem.origin + 1.01 * metres * aside;
                changes = changes || solve(shifted).hit != hit;
            }
            changing += changes ? 1 : 0;
        }
        EXPECT_GE(changing, kind == shapeSphere ? 40 : 20) << "kind " << kind;
    }
}

} // namespace dioptre
