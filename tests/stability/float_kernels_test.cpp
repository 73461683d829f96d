// The suite can fail: the textbook's sphere does where it should, and passes where nothing is hard.
#include "float_kernels.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

constexpr std::size_t rays = 20000;

Verdict verdictOn(std::string_view name, DeviceAnswer (*kernel)(const RayProblem&))
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

TEST(Stability_HainesSphere, PassesWhatItIsKnownToMaster)
{
    for (const char* name : {"S01", "S07", "S08"}) {
        const Verdict verdict = verdictOn(name, hainesSphere);
        EXPECT_TRUE(verdict.pass) << name << ": " << verdict.reason;
    }
}

// No gate is out of a float's reach.
TEST(Stability_Gates, AreMetByTheOracleItself_RoundedToFloat)
{
    for (const CaseRow& row : caseRows()) {
        const Verdict verdict = verdictOn(row.name, oracleInFloat);
        EXPECT_TRUE(verdict.pass) << row.name << ": " << verdict.reason;
    }
}

} // namespace dioptre
