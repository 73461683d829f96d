// Answers that are whole numbers or fractions, at scales from 1e-6 to 1e8, turned and shifted.
#include "problems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre
{
namespace
{

struct Known {
    std::string name; // what the ray does
    RayProblem problem;
    double t;
    glm::dvec3 normal; // any length
    double cosIncidence;
};

const std::array<double, 9> ball{0, 0, 0, 5};
const std::array<double, 9> pipe{0, 0, 0, 0, 10, 0, 5};
const std::array<double, 9> triangle{0, 0, 0, 6, 0, 0, 0, 6, 0};
// Its edges are not at right angles: u = (4, 0, 0), v = (2, 0, 3).
const std::array<double, 9> parallelogram{0, 0, 0, 4, 0, 0, 2, 0, 3};

std::vector<Known> knownHits()
{
    return {
        {"sphere at a chord 3 from its centre",
         problemOf(0, ball, {-20, 3, 0}, {1, 0, 0}),
         16,
         {-4, 3, 0},
         0.8},
        {"sphere by a direction of length 2", problemOf(0, ball, {-20, 3, 0}, {2, 0, 0}), 8, {-4, 3, 0}, 0.8},
        {"sphere in the point (2, 3, 6)",
         problemOf(0, {0, 0, 0, 7}, {6, 11, 14}, {-1, -2, -2}),
         4,
         {2, 3, 6},
         20.0 / 21.0},
        {"sphere from its centre", problemOf(0, ball, {0, 0, 0}, {0, 0, -1}), 5, {0, 0, -5}, 1},
        {"sphere from inside", problemOf(0, ball, {-1, 3, 0}, {1, 0, 0}), 5, {4, 3, 0}, 0.8},
        {"sphere touched", problemOf(0, ball, {-20, 5, 0}, {1, 0, 0}), 20, {0, 5, 0}, 0},
        {"open cylinder's wall", problemOf(1, pipe, {-20, 2, 3}, {1, 0, 0}), 16, {-4, 0, 3}, 0.8},
        {"open cylinder's wall from below",
         problemOf(1, pipe, {-9, -2, 3}, {1, 1, 0}),
         5,
         {-4, 0, 3},
         0.8 / std::sqrt(2.0)},
        {"open cylinder's far wall through its end",
         problemOf(1, pipe, {0, 20, 0}, {1, -3, 0}),
         5,
         {5, 0, 0},
         1 / std::sqrt(10.0)},
        {"open cylinder from within", problemOf(1, pipe, {0, 5, 0}, {1, 0, 0}), 5, {5, 0, 0}, 1},
        {"open cylinder in its rim", problemOf(1, pipe, {-20, 0, 3}, {1, 0, 0}), 16, {-4, 0, 3}, 0.8},
        {"capped cylinder's wall", problemOf(2, pipe, {-20, 2, 3}, {1, 0, 0}), 16, {-4, 0, 3}, 0.8},
        {"capped cylinder's top", problemOf(2, pipe, {1, 20, 1}, {0, -1, 0}), 10, {0, 1, 0}, 1},
        {"capped cylinder's top, aslant",
         problemOf(2, pipe, {0, 22, 0}, {1, -4, 0}),
         3,
         {0, 1, 0},
         4 / std::sqrt(17.0)},
        {"capped cylinder's base", problemOf(2, pipe, {1, -7, 1}, {0, 1, 0}), 7, {0, -1, 0}, 1},
        {"capped cylinder's top from within", problemOf(2, pipe, {1, 5, 1}, {0, 1, 0}), 5, {0, 1, 0}, 1},
        {"capped cylinder's wall from within", problemOf(2, pipe, {-1, 5, 3}, {1, 0, 0}), 5, {4, 0, 3}, 0.8},
        {"plane, its normal not unit",
         problemOf(3, {0, 0, 0, 0, 3, 4}, {0, 10, 0}, {0, -2, 0}),
         5,
         {0, 3, 4},
         0.6},
        {"plane from behind", problemOf(3, {0, 1, 0, 0, 1, 0}, {7, -2, 7}, {0, 1, 0}), 3, {0, 1, 0}, 1},
        {"disk in its rim", problemOf(4, {0, 0, 0, 0, 0, 2, 5}, {3, 4, 6}, {0, 0, -1}), 6, {0, 0, 1}, 1},
        {"disk aslant", problemOf(4, {0, 0, 0, 0, 0, 2, 5}, {0, 0, 4}, {3, 0, -4}), 1, {0, 0, 1}, 0.8},
        {"parallelogram beyond its first edge",
         problemOf(5, parallelogram, {5, 8, 2}, {0, -1, 0}),
         8,
         {0, -1, 0},
         1},
        {"triangle", problemOf(6, triangle, {2, 3, 5}, {0, 0, -1}), 5, {0, 0, 1}, 1},
        {"triangle in its edge", problemOf(6, triangle, {3, 3, 5}, {0, 0, -1}), 5, {0, 0, 1}, 1},
        {"triangle in its corner", problemOf(6, triangle, {6, 0, 5}, {0, 0, -1}), 5, {0, 0, 1}, 1},
    };
}

std::vector<Known> knownMisses()
{
    return {
        {"sphere passed", problemOf(0, ball, {-20, 6, 0}, {1, 0, 0}), 0, {}, 0},
        {"sphere behind the ray", problemOf(0, ball, {20, 3, 0}, {1, 0, 0}), 0, {}, 0},
        {"open cylinder along its axis", problemOf(1, pipe, {1, 20, 1}, {0, -1, 0}), 0, {}, 0},
        {"open cylinder in at one end and out at the other",
         problemOf(1, pipe, {0, 20, 0}, {1, -6, 0}),
         0,
         {},
         0},
        {"open cylinder passed above its rim", problemOf(1, pipe, {-20, 11, 3}, {1, 0, 0}), 0, {}, 0},
        {"capped cylinder beside its axis", problemOf(2, pipe, {4, 20, 4}, {0, -1, 0}), 0, {}, 0},
        {"capped cylinder passed above", problemOf(2, pipe, {-20, 11, 3}, {1, 0, 0}), 0, {}, 0},
        {"plane from a ray along it", problemOf(3, {0, 0, 0, 0, 1, 0}, {0, 1, 0}, {1, 0, 1}), 0, {}, 0},
        {"plane from a ray within it", problemOf(3, {0, 0, 0, 0, 1, 0}, {3, 0, 0}, {1, 0, 1}), 0, {}, 0},
        {"disk passed", problemOf(4, {0, 0, 0, 0, 0, 2, 5}, {4, 4, 6}, {0, 0, -1}), 0, {}, 0},
        {"parallelogram passed within its bounding box",
         problemOf(5, parallelogram, {0.5, 8, 2}, {0, -1, 0}),
         0,
         {},
         0},
        {"triangle passed within its bounding box", problemOf(6, triangle, {4, 3, 5}, {0, 0, -1}), 0, {}, 0},
    };
}

// 1e-6 to 1e8, in powers of two: the images' numbers are exact.
const std::array<double, 5> scales{0x1p-20, 0x1p-10, 1.0, 0x1p13, 0x1p27};

void expectAnswer(const Known& known, const RayProblem& problem, const glm::dvec3& normal)
{
    const RayAnswer answer = solve(problem);
    ASSERT_TRUE(answer.hit);
    EXPECT_EQ(answer.t, known.t);
    const glm::dvec3 point = problem.origin + known.t * problem.direction;
    EXPECT_LE(glm::length(answer.point - point), 1e-15 * glm::length(point));
    EXPECT_LE(glm::length(answer.normal - glm::normalize(normal)), 3e-16);
    EXPECT_NEAR(answer.cosIncidence, known.cosIncidence, 2e-16);
}

} // namespace

TEST(Oracle_ClosedForms, Hits_AreExact_AtEveryScale)
{
    for (const Known& known : knownHits()) {
        SCOPED_TRACE(known.name);
        expectAnswer(known, known.problem, known.normal);
        for (const double scale : scales)
            for (const double shift : {0.0, 1024.0}) {
                SCOPED_TRACE("scale " + std::to_string(scale) + ", shift " + std::to_string(shift));
                const RayProblem image =
                    imageOf(known.problem, scale, glm::dvec3(-shift, shift, shift) * scale);
                expectAnswer(known, image, tripleTurn(known.normal));
            }
    }
}

TEST(Oracle_ClosedForms, Misses_AreMisses_AtEveryScale)
{
    for (const Known& known : knownMisses())
        for (const double scale : scales) {
            SCOPED_TRACE(known.name + ", scale " + std::to_string(scale));
            EXPECT_FALSE(solve(known.problem).hit);
            EXPECT_FALSE(solve(imageOf(known.problem, scale)).hit);
        }
}

TEST(Oracle_Touching, OneStepOfADoubleFurtherOut_IsAMiss)
{
    const double beyond = std::nextafter(5.0, 6.0);
    const double within = std::nextafter(5.0, 4.0);
    EXPECT_FALSE(solve(problemOf(0, ball, {-20, beyond, 0}, {1, 0, 0})).hit);
    EXPECT_TRUE(solve(problemOf(0, ball, {-20, within, 0}, {1, 0, 0})).hit);
    EXPECT_FALSE(solve(problemOf(1, pipe, {-20, 2, beyond}, {1, 0, 0})).hit);
    EXPECT_TRUE(solve(problemOf(1, pipe, {-20, 2, within}, {1, 0, 0})).hit);
    EXPECT_FALSE(solve(problemOf(4, {0, 0, 0, 0, 0, 2, 5}, {beyond, 0, 6}, {0, 0, -1})).hit);
}

TEST(Oracle_Touching, AStepInsideTheSilhouette_ChordIsTheGeometricMean)
{
    // Half the chord at a depth e below the silhouette is sqrt(e (2 R - e)).
    const double within = std::nextafter(5.0, 4.0);
    const double depth = 5.0 - within;
    const RayAnswer answer = solve(problemOf(0, ball, {-20, within, 0}, {1, 0, 0}));
    EXPECT_DOUBLE_EQ(20.0 - answer.t, 20.0 - (20.0 - std::sqrt(depth * (10.0 - depth))));
    EXPECT_NEAR(answer.cosIncidence, std::sqrt(depth * (10.0 - depth)) / 5.0, 1e-22);
}

TEST(Oracle_NearestDistance, BeyondTheNearCrossing_TheFarOneIsTheFirst)
{
    RayProblem problem = problemOf(0, ball, {-20, 3, 0}, {1, 0, 0});
    problem.tMin = std::nextafter(16.0, 0.0);
    EXPECT_EQ(solve(problem).t, 16.0);
    problem.tMin = 16.0;
    EXPECT_EQ(solve(problem).t, 24.0);
    problem.tMin = 24.0;
    EXPECT_FALSE(solve(problem).hit);
}

TEST(Oracle_LeavingASurface, TheStartItself_DoesNotCount)
{
    struct Start {
        std::string name;
        RayProblem problem;
        double t; // 0: a miss
    };
    const std::vector<Start> starts{
        {"sphere, inwards", problemOf(0, ball, {-4, 3, 0}, {1, 0, 0}), 8},
        {"sphere, inwards from a hair outside", problemOf(0, ball, {-4 - 0x1p-30, 3, 0}, {1, 0, 0}),
         8 + 0x1p-30},
        {"sphere, outwards", problemOf(0, ball, {-4, 3, 0}, {-1, 0, 0}), 0},
        {"sphere, outwards from a hair inside", problemOf(0, ball, {-4 + 0x1p-30, 3, 0}, {-1, 0, 0}), 0},
        {"open cylinder, inwards", problemOf(1, pipe, {-5 - 0x1p-30, 5, 0}, {1, 0, 0}), 10 + 0x1p-30},
        {"open cylinder, inwards from a hair below its rim", problemOf(1, pipe, {-5, -0x1p-30, 0}, {1, 1, 0}),
         10},
        {"open cylinder, outwards", problemOf(1, pipe, {-5 + 0x1p-30, 5, 0}, {-1, 0, 0}), 0},
        {"capped cylinder, down from its top", problemOf(2, pipe, {1, 10 + 0x1p-30, 1}, {0, -1, 0}),
         10 + 0x1p-30},
        {"capped cylinder, up from its top", problemOf(2, pipe, {1, 10 - 0x1p-30, 1}, {0, 1, 0}), 0},
        {"capped cylinder, inwards from its wall", problemOf(2, pipe, {-5, 5, 0}, {1, 0, 0}), 10},
        {"plane", problemOf(3, {0, 0, 0, 0, 1, 0}, {0, -0x1p-30, 0}, {0, 1, 0}), 0},
        {"triangle", problemOf(6, triangle, {1, 1, 0x1p-30}, {0, 0, -1}), 0},
    };
    for (Start start : starts) {
        SCOPED_TRACE(start.name);
        start.problem.spawn = true;
        const RayAnswer answer = solve(start.problem);
        EXPECT_EQ(answer.hit, start.t > 0.0);
        EXPECT_EQ(answer.t, start.t);
    }
}

TEST(Oracle_Hits_ThatNoFloatCouldTell, AreTold)
{
    // A sphere of 1e-4 seen from 1e3 away: the chord is 1e-7 of the way.
    const RayAnswer far = solve(problemOf(0, {0, 0, 0, 0x1p-13}, {-0x1p10, 0, 0}, {1, 0, 0}));
    EXPECT_EQ(far.t, 0x1p10 - 0x1p-13);
    // From a millionth of a radius above a planet, straight down and level.
    const std::array<double, 9> planet{0, 0, 0, 0x1p23};
    EXPECT_EQ(solve(problemOf(0, planet, {0, 0x1p23 + 8, 0}, {0, -1, 0})).t, 8.0);
    EXPECT_FALSE(solve(problemOf(0, planet, {0, 0x1p23 + 8, 0}, {1, 0, 0})).hit);
}

} // namespace dioptre
