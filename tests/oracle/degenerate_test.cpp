#include "problems.h"

#include <gtest/gtest.h>

#include <limits>

namespace dioptre
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

// One of each kind, all hit by the ray from (0.25, 0.25, 9) along -z.
std::vector<RayProblem> sound()
{
    const glm::dvec3 o(0.25, 0.25, 9.0);
    const glm::dvec3 d(0.0, 0.0, -1.0);
    return {problemOf(0, {0, 0, 0, 1}, o, d),
            problemOf(1, {0, -2, 0, 0, 4, 0, 1}, o, d),
            problemOf(2, {0, -2, 0, 0, 4, 0, 1}, o, d),
            problemOf(3, {0, 0, 0, 0, 0, 1}, o, d),
            problemOf(4, {0, 0, 0, 0, 0, 1, 1}, o, d),
            problemOf(5, {0, 0, 0, 1, 0, 0, 0, 1, 0}, o, d),
            problemOf(6, {0, 0, 0, 1, 0, 0, 0, 1, 0}, o, d)};
}

std::size_t numbersOf(int primitive)
{
    constexpr std::array<std::size_t, 7> counts{4, 7, 7, 6, 7, 9, 9};
    return counts[static_cast<std::size_t>(primitive)];
}

void expectMiss(const RayProblem& problem)
{
    const RayAnswer answer = solve(problem);
    EXPECT_FALSE(answer.hit);
    EXPECT_EQ(answer.t, 0.0);
    EXPECT_EQ(answer.margin, inf);
}

} // namespace

TEST(Oracle_Degenerate, TheSoundProblems_AreHit)
{
    for (const RayProblem& problem : sound())
        EXPECT_TRUE(solve(problem).hit) << problem.primitive;
}

TEST(Oracle_Degenerate, AnyNumberNotFinite_IsAMiss)
{
    for (const RayProblem& problem : sound())
        for (const double bad : {nan, inf, -inf}) {
            SCOPED_TRACE("primitive " + std::to_string(problem.primitive) + " with " + std::to_string(bad));
            for (std::size_t i = 0; i < numbersOf(problem.primitive); ++i) {
                RayProblem broken = problem;
                broken.p[i] = bad;
                expectMiss(broken);
            }
            for (int i = 0; i < 3; ++i) {
                RayProblem broken = problem;
                broken.origin[i] = bad;
                expectMiss(broken);
                broken = problem;
                broken.direction[i] = bad;
                expectMiss(broken);
            }
        }
}

TEST(Oracle_Degenerate, RadiusNotPositive_IsAMiss)
{
    for (const RayProblem& problem : sound())
        for (const double bad : {0.0, -0.0, -1.0}) {
            RayProblem broken = problem;
            if (problem.primitive == shapeSphere)
                broken.p[3] = bad;
            else if (problem.primitive != shapePlane && problem.primitive <= shapeDisk)
                broken.p[6] = bad;
            else
                continue;
            expectMiss(broken);
        }
}

TEST(Oracle_Degenerate, ZeroDirectionAxisOrNormal_IsAMiss)
{
    for (const RayProblem& problem : sound()) {
        RayProblem broken = problem;
        broken.direction = glm::dvec3(0.0);
        expectMiss(broken);
        if (problem.primitive == shapeSphere)
            continue;
        broken = problem;
        setPart(broken.p, 3, glm::dvec3(0.0));
        expectMiss(broken);
    }
}

TEST(Oracle_Degenerate, EdgesOnOneLine_AreAMiss)
{
    const glm::dvec3 o(0.1, 0.2, 9.0);
    const glm::dvec3 d(0.0, 0.0, -1.0);
    // Thirds and tenths: their products are no doubles, and the edges still on one line exactly, one twice
    // the other.
    const std::array<double, 3> edge{1.0 / 3.0, 0.1, 0.7};
    const std::array<double, 3> twice{2.0 / 3.0, 0.2, 1.4};
    expectMiss(problemOf(5, {0, 0, 0, edge[0], edge[1], edge[2], twice[0], twice[1], twice[2]}, o, d));
    expectMiss(problemOf(6, {0, 0, 0, edge[0], edge[1], edge[2], twice[0], twice[1], twice[2]}, o, d));
    expectMiss(problemOf(6, {1, 2, 3, 1, 2, 3, 4, 5, 6}, o, d));
    expectMiss(problemOf(6, {1, 2, 3, 4, 5, 6, 4, 5, 6}, o, d));
}

TEST(Oracle_Degenerate, AKindThatIsNone_IsAMiss)
{
    for (const int kind : {-1, 7}) {
        RayProblem broken = sound().front();
        broken.primitive = kind;
        expectMiss(broken);
    }
}

} // namespace dioptre
