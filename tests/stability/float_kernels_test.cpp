// The suite can fail: the textbook's sphere does where it should, and passes where nothing is hard.
#include "float_kernels.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

Verdict verdictOn(std::string_view name, DeviceAnswer (*kernel)(const RayProblem&), std::size_t rays = 20000)
{
    const CaseRow& row = caseRow(name);
    const std::vector<RayProblem> problems = problemsOf(name, 1, rays);
    std::vector<DeviceAnswer> answers;
    for (const RayProblem& problem : problems)
        answers.push_back(kernel(problem));
    return judgeCase(row, measureCase(row, problems, answersOf(problems), answers));
}

DeviceAnswer oracleInFloat(const RayProblem& problem)
{
    const RayAnswer truth = solve(problem);
    return {truth.hit, static_cast<double>(static_cast<float>(truth.t)), truth.normal};
}

} // namespace

TEST(Stability_TextbookSphere, FailsEveryHardCase)
{
    for (const char* name : {"S01", "S02", "S03", "S04", "S05", "S06", "S07", "S10", "S11", "S13"}) {
        const Verdict verdict = verdictOn(name, textbookSphere);
        EXPECT_FALSE(verdict.pass) << name;
        EXPECT_FALSE(verdict.reason.empty()) << name;
    }
}

TEST(Stability_TextbookSphere, PassesTheControl)
{
    const Verdict verdict = verdictOn("S08", textbookSphere);
    EXPECT_TRUE(verdict.pass) << verdict.reason;
}

TEST(Stability_HainesSphere, PassesWhatItIsKnownToMaster_AndNoMore)
{
    for (const char* name : {"S01", "S08"}) {
        const Verdict verdict = verdictOn(name, hainesSphere);
        EXPECT_TRUE(verdict.pass) << name << ": " << verdict.reason;
    }
    for (const char* name : {"S03", "S05", "S10", "S11"})
        EXPECT_FALSE(verdictOn(name, hainesSphere).pass) << name;
}

TEST(Stability_CurvatureForm, PassesThePlanet)
{
    const Verdict verdict = verdictOn("S05", curvedGround);
    EXPECT_TRUE(verdict.pass) << verdict.reason;
}

// No gate is out of a float's reach.
TEST(Stability_Gates, AreMetByTheOracleItself_RoundedToFloat)
{
    for (const CaseRow& row : caseRows()) {
        const Verdict verdict = verdictOn(row.name, oracleInFloat, 3000);
        EXPECT_TRUE(verdict.pass) << row.name << ": " << verdict.reason;
    }
}

} // namespace dioptre
