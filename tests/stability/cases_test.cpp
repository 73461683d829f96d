// What the cases' problems are: the same everywhere, floats, and what their row says.
#include "base/error.h"
#include "stability/case_rows.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <set>

namespace dioptre
{
namespace
{

constexpr std::size_t rays = 3000;

std::vector<double> numbersOf(const RayProblem& problem)
{
    std::vector<double> numbers(problem.p.begin(), problem.p.end());
    for (int i = 0; i < 3; ++i) {
        numbers.push_back(problem.origin[i]);
        numbers.push_back(problem.direction[i]);
    }
    return numbers;
}

// FNV-1a over the numbers' bits; every NaN alike.
std::uint64_t fingerprint(std::span<const RayProblem> problems)
{
    std::uint64_t hash = 14695981039346656037U;
    for (const RayProblem& problem : problems)
        for (const double number : numbersOf(problem)) {
            const double plain = std::isnan(number) ? std::numeric_limits<double>::quiet_NaN() : number;
            hash = (hash ^ std::bit_cast<std::uint64_t>(plain)) * 1099511628211U;
        }
    return hash;
}

glm::dvec3 part(const RayProblem& problem, std::size_t first)
{
    return {problem.p[first], problem.p[first + 1], problem.p[first + 2]};
}

// Of the line from the sphere's centre.
double impactOf(const RayProblem& problem)
{
    const glm::dvec3 f = problem.origin - part(problem, 0);
    return glm::length(glm::cross(f, glm::normalize(problem.direction)));
}

double shareOfHits(std::string_view name)
{
    const std::vector<RayProblem> problems = problemsOf(name, 1, rays);
    std::size_t hits = 0;
    for (const RayAnswer& answer : answersOf(problems))
        hits += answer.hit ? 1 : 0;
    return static_cast<double>(hits) / static_cast<double>(problems.size());
}

} // namespace

TEST(Stability_Cases, Names_AreUnique_AndEachCaseAsksForSomething)
{
    std::set<std::string_view> names;
    for (const CaseRow& row : caseRows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.about.empty());
        EXPECT_FALSE(gateText(row.gate).empty()) << row.name;
        EXPECT_EQ(&caseRow(row.name), &row);
    }
    for (const char* name :
         {"S01", "S02", "S03", "S04", "S05", "S06", "S07", "S08", "S10", "S11", "S13", "C01",
          "C02", "C03", "C04", "C05", "C06", "C07", "C08", "P02", "D02", "T02", "T06", "T08"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Stability_Cases, AnUnknownName_IsRefusedWithTheKnownOnes)
{
    try {
        problemsOf("S99", 1, 1);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("S99"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("S13"), std::string::npos);
    }
}

TEST(Stability_Cases, TheSameSeed_GivesTheSameProblems_AnotherSeedOthers)
{
    for (const CaseRow& row : caseRows()) {
        const auto first = problemsOf(row.name, 7, 300);
        EXPECT_EQ(fingerprint(first), fingerprint(problemsOf(row.name, 7, 300))) << row.name;
        EXPECT_NE(fingerprint(first), fingerprint(problemsOf(row.name, 8, 300))) << row.name;
        // More rays are the same ones and further ones.
        const auto more = problemsOf(row.name, 7, 600);
        EXPECT_EQ(fingerprint(first), fingerprint(std::span(more).first(300))) << row.name;
    }
}

// Of 600 problems of each case as they were first drawn, by g++ and clang++ alike: a change of a case, or a
// compiler that rounds in another way, shows here.
TEST(Stability_Cases, Problems_AreTheSameOnEveryPlatform)
{
    std::uint64_t all = 0;
    for (const CaseRow& row : caseRows())
        all = all * 31 + fingerprint(problemsOf(row.name, 1, 600));
    EXPECT_EQ(all, 1311666054178130432U);
}

TEST(Stability_Cases, EveryNumber_IsAFloat)
{
    for (const CaseRow& row : caseRows())
        for (const RayProblem& problem : problemsOf(row.name, 2, rays))
            for (const double number : numbersOf(problem)) {
                const volatile auto nearest = static_cast<float>(number);
                ASSERT_TRUE(std::isnan(number) || static_cast<double>(nearest) == number)
                    << row.name << ", problem " << problem.id;
            }
}

TEST(Stability_Cases, Directions_AreUnitToFloat_SaveWhereTheirLengthIsTheCase)
{
    for (const CaseRow& row : caseRows()) {
        double shortest = 1.0;
        double longest = 1.0;
        for (const RayProblem& problem : problemsOf(row.name, 3, rays)) {
            const double length = glm::length(problem.direction);
            if (row.name == "degenerate" && !std::isfinite(length))
                continue;
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
        }
        if (row.name == "S10") {
            EXPECT_LT(shortest, 1e-2);
            EXPECT_GT(longest, 1e2);
        } else {
            EXPECT_GT(shortest, 1.0 - 1.5e-7) << row.name;
            EXPECT_LT(longest, 1.0 + 1.5e-7) << row.name;
        }
    }
}

TEST(Stability_Cases, Groups_AreWhole_AndShareTheirRay)
{
    const CaseRow& row = caseRow("edges");
    const auto problems = problemsOf("edges", 1, 1000);
    ASSERT_EQ(problems.size() % row.group, 0U);
    ASSERT_GE(problems.size(), 1000U);
    const auto answers = answersOf(problems);
    for (std::size_t i = 0; i < problems.size(); i += row.group) {
        int hits = 0;
        for (std::size_t k = i; k < i + row.group; ++k) {
            EXPECT_EQ(problems[k].origin, problems[i].origin);
            EXPECT_EQ(problems[k].direction, problems[i].direction);
            hits += answers[k].hit ? 1 : 0;
        }
        EXPECT_GE(hits, 1) << problems[i].id;
    }
    // The rays pass edges and corners as near as floats allow.
    std::size_t near = 0;
    for (const RayAnswer& answer : answers)
        near += answer.margin < 8.0 ? 1 : 0;
    EXPECT_GE(near, 2 * problems.size() / row.group);
}

TEST(Stability_Cases, HitsAndMisses_BothOccur_WhereBothCount)
{
    for (const char* name : {"S01", "S02", "S03", "S04", "S05", "S06", "S10", "S11", "S13", "C01", "C02",
                             "C04", "C05", "C08", "P01", "D01", "D02", "R01", "T02", "T06", "T08"}) {
        EXPECT_GT(shareOfHits(name), 0.5) << name;
        EXPECT_LT(shareOfHits(name), 0.95) << name;
    }
    for (const char* name : {"S07", "C03", "C06", "leaving", "T01"}) {
        EXPECT_GT(shareOfHits(name), 0.2) << name;
        EXPECT_LT(shareOfHits(name), 0.6) << name;
    }
    for (const char* name : {"S08", "C07", "P02", "neighbour"})
        EXPECT_EQ(shareOfHits(name), 1.0) << name;
    EXPECT_EQ(shareOfHits("degenerate"), 0.0);
}

TEST(Stability_S07, ImpactParameters_LieWithin1em8To1em2OfTheRadius_InEveryDecade)
{
    std::array<int, 6> decades{};
    for (const RayProblem& problem : problemsOf("S07", 4, rays)) {
        const double off = std::abs(impactOf(problem) / problem.p[3] - 1.0);
        ASSERT_GE(off, 0.99e-8);
        ASSERT_LE(off, 1.01e-2);
        ++decades[static_cast<std::size_t>(std::clamp(std::floor(std::log10(off)) + 8.0, 0.0, 5.0))];
    }
    for (const int count : decades)
        EXPECT_GT(count, static_cast<int>(rays) / 12);
}

TEST(Stability_C06, TheAxis_IsPassedAtARadiusWithin1em2_AndOftenWithin1em6)
{
    std::size_t close = 0;
    for (const RayProblem& problem : problemsOf("C06", 4, rays)) {
        const glm::dvec3 across = glm::normalize(glm::cross(problem.direction, part(problem, 3)));
        const double impact = std::abs(glm::dot(problem.origin - part(problem, 0), across));
        const double off = std::abs(impact / problem.p[6] - 1.0);
        ASSERT_GE(off, 0.99e-8);
        ASSERT_LE(off, 1.01e-2);
        close += off < 1e-6 ? 1 : 0;
    }
    EXPECT_GT(close, rays / 6);
}

TEST(Stability_Distances, AreThoseOfTheRows)
{
    for (const auto& [name, radii] : {std::pair{"S02", 1e4}, {"S03", 1e7}, {"S04", 1e5}, {"S13", 2e3}})
        for (const RayProblem& problem : problemsOf(name, 5, 300))
            EXPECT_NEAR(glm::length(problem.origin - part(problem, 0)) / problem.p[3], radii, 1e-3 * radii)
                << name;
    for (const RayProblem& problem : problemsOf("S06", 5, 300))
        EXPECT_NEAR(glm::length(part(problem, 0)), 1e6, 1.0);
    for (const RayProblem& problem : problemsOf("S08", 5, 300))
        EXPECT_LT(glm::length(problem.origin - part(problem, 0)), 0.96 * problem.p[3]);
    for (const RayProblem& problem : problemsOf("S11", 5, 300)) {
        const double above = glm::length(problem.origin - part(problem, 0)) / problem.p[3] - 1.0;
        EXPECT_GE(above, 0.99e-6);
        EXPECT_LE(above, 1.01e-2);
    }
    for (const RayProblem& problem : problemsOf("C03", 5, 300)) {
        const glm::dvec3 axis = glm::normalize(part(problem, 3));
        const double sine = glm::length(glm::cross(axis, problem.direction));
        EXPECT_LT(sine, 1.2e-3);
    }
}

TEST(Stability_P02, ThePlane_IsMetAtAMicroradian)
{
    const auto problems = problemsOf("P02", 6, 300);
    for (const RayAnswer& answer : answersOf(problems)) {
        EXPECT_GT(answer.cosIncidence, 0.49e-6);
        EXPECT_LT(answer.cosIncidence, 2.1e-6);
    }
}

TEST(Stability_Leaving, OutwardsIsAMiss_InwardsTheFarSide)
{
    const auto problems = problemsOf("leaving", 6, rays);
    const auto answers = answersOf(problems);
    for (std::size_t i = 0; i < problems.size(); ++i) {
        ASSERT_TRUE(problems[i].spawn);
        if (problems[i].primitive != shapeSphere)
            continue;
        const double outwards = glm::dot(problems[i].origin - part(problems[i], 0), problems[i].direction);
        EXPECT_EQ(answers[i].hit, outwards < 0.0) << problems[i].id;
        if (outwards < 0.0) {
            EXPECT_NEAR(answers[i].t, -2.0 * outwards, 0.15 * answers[i].t) << problems[i].id;
        }
    }
}

} // namespace dioptre
