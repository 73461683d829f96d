// The judge finds each error that is planted, names it, and sees nothing where nothing is wrong.
#include "stability/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

// A row's problems, their truth, and the truth as a device's answers, to be spoilt.
struct Trial {
    CaseRow row;
    std::vector<RayProblem> problems;
    std::vector<RayAnswer> truth;
    std::vector<DeviceAnswer> answers;

    Verdict verdict() const
    {
        return judgeCase(row, figures());
    }
    CaseFigures figures() const
    {
        return measureCase(row, problems, truth, answers);
    }
};

const Gate everything{.k = 8.0,
                      .relativeT = 1e-6,
                      .relativeT_p999 = 1e-6,
                      .normal_rad = 1e-6,
                      .flips = 0.0,
                      .flipsOverMargin = 0.0,
                      .leaks = {}};

Trial trialOf(std::string_view name, const Gate& gate, std::size_t count = 1000)
{
    Trial trial;
    trial.row = caseRow(name);
    trial.row.gate = gate;
    trial.problems = problemsOf(name, 1, count);
    trial.truth = answersOf(trial.problems);
    for (const RayAnswer& answer : trial.truth)
        trial.answers.push_back({answer.hit, answer.t, answer.normal});
    return trial;
}

// The first ray with that answer, over the margin.
std::size_t firstRay(const Trial& trial, bool hit, double margin)
{
    for (std::size_t i = 0; i < trial.truth.size(); ++i)
        if (trial.truth[i].hit == hit && trial.truth[i].margin > margin)
            return i;
    ADD_FAILURE() << "no such ray";
    return 0;
}

bool names(const Verdict& verdict, std::string_view what)
{
    return !verdict.pass && verdict.reason.find(what) != std::string::npos;
}

} // namespace

TEST(Stability_Judge, TheTruth_Passes)
{
    const Trial trial = trialOf("S01", everything);
    EXPECT_TRUE(trial.verdict().pass) << trial.verdict().reason;
    EXPECT_EQ(trial.figures().k, 0.0);
    EXPECT_EQ(trial.figures().rays, 1000U);
    EXPECT_GT(trial.figures().judgedOver64, 700U);
}

TEST(Stability_Judge, AnErrorOfT_IsMeasuredInKAndInShares)
{
    Trial trial = trialOf("S01", everything);
    const std::size_t i = firstRay(trial, true, 64.0);
    const double unit = 0x1p-24 * extentOf(trial.problems[i]);
    const double metres = 9.0 * unit / trial.truth[i].cosIncidence;
    trial.answers[i].t += metres / glm::length(trial.problems[i].direction);
    EXPECT_NEAR(trial.figures().k, 9.0, 1e-6);
    EXPECT_NEAR(trial.figures().relativeT, metres / trial.truth[i].t, 1e-6 * metres);
    EXPECT_TRUE(names(trial.verdict(), "K 9 exceeds 8"));
    trial.row.gate = {.k = 9.1, .flips = 0.0};
    EXPECT_TRUE(trial.verdict().pass) << trial.verdict().reason;
    trial.row.gate = {.relativeT = 0.5 * metres / trial.truth[i].t};
    EXPECT_TRUE(names(trial.verdict(), "relative t"));
}

TEST(Stability_Judge, TheLengthOfTheDirection_DoesNotChangeK)
{
    Trial trial = trialOf("S10", {.k = 8.0});
    for (std::size_t i = 0; i < trial.problems.size(); ++i) {
        const double metres = 3.0 * 0x1p-24 * extentOf(trial.problems[i]);
        if (trial.truth[i].hit)
            trial.answers[i].t +=
                metres / trial.truth[i].cosIncidence / glm::length(trial.problems[i].direction);
    }
    EXPECT_NEAR(trial.figures().k, 3.0, 1e-6);
}

TEST(Stability_Judge, ATurnedNormal_IsMeasuredInRadians)
{
    Trial trial = trialOf("S01", {.normal_rad = 1e-6});
    const std::size_t i = firstRay(trial, true, 64.0);
    const glm::dvec3 normal = trial.truth[i].normal;
    const glm::dvec3 across = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.7)));
    trial.answers[i].normal = 5.0 * (normal + std::tan(2e-6) * across); // of any length
    EXPECT_NEAR(trial.figures().normal_rad, 2e-6, 1e-12);
    EXPECT_TRUE(names(trial.verdict(), "normal"));
    trial.answers[i].normal = -normal;
    EXPECT_NEAR(trial.figures().normal_rad, std::acos(-1.0), 1e-12);
}

TEST(Stability_Judge, AFlip_CountsOnce_AndOverMarginOnlyThere)
{
    Trial trial = trialOf("S07", {.flips = 0.0});
    const std::size_t miss = firstRay(trial, false, 64.0);
    trial.answers[miss] = {true, 1.0, {0.0, 1.0, 0.0}};
    EXPECT_DOUBLE_EQ(trial.figures().flips, 1000.0);
    EXPECT_DOUBLE_EQ(trial.figures().flipsOverMargin, 1000.0);
    EXPECT_TRUE(names(trial.verdict(), "flips per million 1e+03 exceeds 0"));

    trial = trialOf("S07", {.flipsOverMargin = 0.0});
    std::size_t close = 0;
    for (std::size_t i = 0; i < trial.truth.size(); ++i)
        if (trial.truth[i].margin < 8.0) {
            trial.answers[i].hit = !trial.truth[i].hit;
            trial.answers[i].t = 1.0;
            ++close;
        }
    EXPECT_GT(close, 100U);
    EXPECT_DOUBLE_EQ(trial.figures().flips, 1000.0 * static_cast<double>(close));
    EXPECT_EQ(trial.figures().flipsOverMargin, 0.0);
    EXPECT_TRUE(trial.verdict().pass) << trial.verdict().reason;
    trial.row.gate = {.flips = 0.0};
    EXPECT_FALSE(trial.verdict().pass);
}

TEST(Stability_Judge, TheFarSide_InPlaceOfTheNear_IsFound)
{
    Trial trial = trialOf("S01", {.k = 8.0});
    const std::size_t i = firstRay(trial, true, 64.0);
    trial.answers[i].t += 2.0 * trial.problems[i].p[3] * trial.truth[i].cosIncidence;
    EXPECT_TRUE(names(trial.verdict(), "K"));
}

TEST(Stability_Judge, NanAndInfinity_AreCountedWhereverTheyStand)
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Trial trial = trialOf("S01", {});
        trial.answers[firstRay(trial, true, 8.0)].t = bad;
        trial.answers[firstRay(trial, false, 8.0)].normal.z = bad;
        EXPECT_EQ(trial.figures().nonFinite, 2U);
        EXPECT_TRUE(names(trial.verdict(), "2 answers hold a NaN or an infinity"));
    }
}

TEST(Stability_Judge, TheQuantile_ForgivesOneRayOfAThousandAndNotTen)
{
    Trial trial = trialOf("T02", {.relativeT_p999 = 1e-6}, 5000);
    std::size_t spoilt = 0;
    for (std::size_t i = 0; i < trial.truth.size() && spoilt < 20; ++i)
        if (trial.truth[i].hit) {
            trial.answers[i].t *= 1.01;
            ++spoilt;
            if (spoilt == 1) {
                EXPECT_TRUE(trial.verdict().pass) << trial.verdict().reason;
            }
        }
    EXPECT_TRUE(names(trial.verdict(), "p99.9"));
}

TEST(Stability_Judge, ALeak_IsAGroupThatNothingHits)
{
    Trial trial = trialOf("edges", {.leaks = 0.0}, 6000);
    EXPECT_TRUE(trial.verdict().pass) << trial.verdict().reason;
    // The neighbour hit in its place is no leak.
    std::size_t hit = firstRay(trial, true, 0.0);
    const std::size_t neighbour = hit % 6 == 5 ? hit - 1 : hit + 1;
    trial.answers[neighbour] = trial.answers[hit];
    trial.answers[hit].hit = false;
    EXPECT_TRUE(trial.verdict().pass) << trial.verdict().reason;
    trial.answers[neighbour].hit = false;
    EXPECT_DOUBLE_EQ(trial.figures().leaks, 1000.0);
    EXPECT_TRUE(names(trial.verdict(), "leaks per million 1e+03 exceeds 0"));
}

TEST(Stability_Judge, AFigureThatNoRayStandsBehind_IsABreach)
{
    Trial trial = trialOf("S01", everything);
    for (DeviceAnswer& answer : trial.answers)
        answer.hit = false;
    EXPECT_TRUE(names(trial.verdict(), "K rests on no ray"));
    EXPECT_TRUE(names(trial.verdict(), "relative t rests on no ray"));
    trial.problems.clear();
    trial.truth.clear();
    trial.answers.clear();
    EXPECT_TRUE(names(trial.verdict(), "flips per million rests on no ray"));
}

TEST(Stability_GateText, SaysWhatIsAsked)
{
    EXPECT_EQ(gateText({.k = 8.0, .flipsOverMargin = 0.0}), "K <= 8, no flips over margin");
    EXPECT_EQ(gateText({.normal_rad = 2e-6, .flips = 0.0}), "normal <= 2e-06 rad, no flips");
    EXPECT_EQ(gateText({.relativeT_p999 = 1e-3, .leaks = 0.0}), "relative t at p99.9 <= 0.001, no leaks");
    EXPECT_EQ(gateText({.relativeT = 0.5, .flips = 300.0}), "relative t <= 0.5, flips per million <= 300");
}

} // namespace dioptre
