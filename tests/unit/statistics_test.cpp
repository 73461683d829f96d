// On made-up timings, whose truth is known.
#include "base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dioptre
{
namespace
{

// A machine whose frames take what they should, times a noise that is now and then a long one.
class MadeUpMachine
{
public:
    explicit MadeUpMachine(unsigned seed) : random_(seed) {}

    double frame_ms(double true_ms)
    {
        const double noise = unit() < 0.1 ? 0.5 * unit() : 0.02 * (unit() - 0.5);
        return true_ms * (1.0 + noise);
    }

private:
    double unit()
    {
        return static_cast<double>(random_()) / 4294967296.0;
    }
    std::mt19937 random_;
};

// `rounds` frames of each input, in turn.
std::vector<std::vector<double>> interleaved(MadeUpMachine& machine, const std::vector<double>& true_ms,
                                             std::size_t rounds)
{
    std::vector<std::vector<double>> times_ms(true_ms.size());
    for (std::size_t round = 0; round < rounds; ++round)
        for (const std::size_t i : roundOrder(true_ms.size(), round))
            times_ms[i].push_back(machine.frame_ms(true_ms[i]));
    return times_ms;
}

} // namespace

TEST(Statistics_Median, IsTheMiddleValue_OrTheMeanOfTheMiddleTwo)
{
    EXPECT_EQ(median(std::vector<double>{3.0}), 3.0);
    EXPECT_EQ(median(std::vector<double>{9.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median(std::vector<double>{4.0, 1.0, 100.0, 2.0}), 3.0);
}

TEST(Statistics_Median, OneDisturbedFrame_DoesNotMoveIt)
{
    EXPECT_EQ(median(std::vector<double>{10.0, 10.0, 5000.0, 10.0, 10.0}), 10.0);
}

TEST(Statistics_Quantile, LiesBetweenNeighbours)
{
    const std::vector<double> values{40.0, 10.0, 30.0, 20.0, 50.0};
    EXPECT_EQ(quantile(values, 0.0), 10.0);
    EXPECT_EQ(quantile(values, 1.0), 50.0);
    EXPECT_EQ(quantile(values, 0.25), 20.0);
    EXPECT_DOUBLE_EQ(quantile(values, 0.375), 25.0);
}

TEST(Statistics_Interval, OfEqualTimings_HasNoWidth)
{
    const Estimate estimate = medianOf(std::vector<double>(30, 7.5));
    EXPECT_EQ(estimate.value, 7.5);
    EXPECT_EQ(estimate.low, 7.5);
    EXPECT_EQ(estimate.high, 7.5);
}

TEST(Statistics_Interval, OfTheSameTimings_IsTheSame)
{
    const std::vector<double> values{5.0, 4.0, 6.0, 5.5, 9.0, 4.5};
    EXPECT_EQ(medianOf(values).low, medianOf(values).low);
    EXPECT_EQ(medianOf(values).high, medianOf(values).high);
}

TEST(Statistics_Interval, HoldsTheTrueMedian_NineteenTimesInTwenty)
{
    // The made-up noise has its median where the 0.9 part of +-1 % has its 5/9 quantile: 0.02 * (5/9 - 1/2).
    const double trueMedian_ms = 20.0 * (1.0 + (0.02 * (5.0 / 9.0 - 0.5)));
    int held = 0;
    constexpr int measurements = 200;
    for (int i = 0; i < measurements; ++i) {
        MadeUpMachine machine(1000U + static_cast<unsigned>(i));
        std::vector<double> times_ms;
        for (int frame = 0; frame < 30; ++frame)
            times_ms.push_back(machine.frame_ms(20.0));
        const Estimate estimate = medianOf(times_ms);
        EXPECT_LE(estimate.low, estimate.value);
        EXPECT_GE(estimate.high, estimate.value);
        held += estimate.low <= trueMedian_ms && trueMedian_ms <= estimate.high ? 1 : 0;
    }
    // 190 are expected of 200, with a standard deviation of 3.1: four of them on either side.
    EXPECT_GE(held, 178);
    EXPECT_LE(held, 200);
}

TEST(Statistics_Interval, MoreRounds_MakeItNarrower)
{
    MadeUpMachine machine(7);
    const auto few = medianOf(interleaved(machine, {20.0}, 10)[0]);
    const auto many = medianOf(interleaved(machine, {20.0}, 1000)[0]);
    EXPECT_LT(many.high - many.low, 0.5 * (few.high - few.low));
}

TEST(Statistics_Ratio, IsThatOfTheMedians)
{
    const Estimate ratio =
        ratioOfMedians(std::vector<double>{30.0, 31.0, 29.0}, std::vector<double>{20.0, 19.0, 21.0});
    EXPECT_DOUBLE_EQ(ratio.value, 1.5);
    EXPECT_LE(ratio.low, 1.5);
    EXPECT_GE(ratio.high, 1.5);
}

TEST(Statistics_Ratio, OfTimingsToThemselves_IsExactlyOne)
{
    const std::vector<double> values{5.0, 4.0, 6.0, 5.5};
    const Estimate ratio = ratioOfMedians(values, values);
    EXPECT_EQ(ratio.value, 1.0);
    EXPECT_EQ(ratio.low, 1.0);
    EXPECT_EQ(ratio.high, 1.0);
}

// Every round half as fast or twice as slow as another, both inputs alike: the ratio knows nothing of it.
TEST(Statistics_Ratio, WhatDisturbsWholeRounds_DoesNotWidenIt)
{
    std::vector<double> baseline, values;
    for (int round = 0; round < 31; ++round) {
        baseline.push_back(10.0 + (round % 7));
        values.push_back(2.0 * baseline.back());
    }
    const Estimate ratio = ratioOfMedians(values, baseline);
    EXPECT_DOUBLE_EQ(ratio.low, 2.0);
    EXPECT_DOUBLE_EQ(ratio.high, 2.0);
}

TEST(Statistics_Spread, IsTheFarthestThatTheControlMayBeFromOne)
{
    EXPECT_NEAR(spreadOf({1.0, 0.99, 1.03}), 0.03, 1e-12);
    EXPECT_NEAR(spreadOf({1.0, 0.8, 1.03}), 0.25, 1e-12); // a factor of 1.25 away
    EXPECT_DOUBLE_EQ(spreadOf({1.0, 1.0, 1.0}), 0.0);
}

TEST(Statistics_Verdict, UnderTheControlsSpread_IsNoDifference)
{
    EXPECT_FALSE(differs({1.02, 1.015, 1.025, 9}, 0.03));
    EXPECT_FALSE(differs({0.98, 0.975, 0.985, 9}, 0.03));
    EXPECT_TRUE(differs({1.04, 1.035, 1.045, 9}, 0.03));
    EXPECT_TRUE(differs({0.9, 0.89, 0.91, 9}, 0.03));
}

TEST(Statistics_Verdict, AnIntervalThatHoldsOne_IsNoDifference)
{
    EXPECT_FALSE(differs({1.1, 0.95, 1.3, 9}, 0.01));
    EXPECT_FALSE(differs({1.0, 1.0, 1.0, 9}, 0.0));
}

TEST(Differs, FewRounds_TellNothing)
{
    const std::vector<double> slow{2.0, 2.1, 2.2, 2.1, 2.0};
    const std::vector<double> quick{1.0, 1.1, 1.2, 1.1, 1.0};
    const auto ratio = [&](std::size_t rounds) {
        return ratioOfMedians(std::span(slow).first(rounds), std::span(quick).first(rounds));
    };
    EXPECT_FALSE(differs(ratio(1), 0.01));
    EXPECT_FALSE(differs(ratio(fewestRounds - 1), 0.01));
    EXPECT_TRUE(differs(ratio(fewestRounds), 0.01));
}

TEST(Statistics_Verdict, OnANoisyMachine_FindsWhatDiffers_AndOnlyThat)
{
    int falseAlarms = 0;
    constexpr int measurements = 100;
    for (unsigned seed = 0; seed < measurements; ++seed) {
        MadeUpMachine machine(seed);
        // The baseline, its equal, what is a tenth slower, and the control.
        const auto times_ms = interleaved(machine, {20.0, 20.0, 22.0, 20.0}, 30);
        const double spread = spreadOf(ratioOfMedians(times_ms[3], times_ms[0]));
        falseAlarms += differs(ratioOfMedians(times_ms[1], times_ms[0]), spread) ? 1 : 0;
        const Estimate slower = ratioOfMedians(times_ms[2], times_ms[0]);
        EXPECT_TRUE(differs(slower, spread)) << "seed " << seed;
        EXPECT_NEAR(slower.value, 1.1, 0.02) << "seed " << seed;
    }
    EXPECT_LE(falseAlarms, 5);
}

TEST(Statistics_RoundOrder, GoesForwardsAndBackwardsInTurn)
{
    EXPECT_EQ(roundOrder(3, 0), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(roundOrder(3, 1), (std::vector<std::size_t>{2, 1, 0}));
    EXPECT_EQ(roundOrder(3, 2), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(roundOrder(1, 5), (std::vector<std::size_t>{0}));
}

// Over two rounds every input has the same mean place, so that a drift moves all medians alike.
TEST(Statistics_RoundOrder, OnAMachineThatGrowsSlower_FavoursNone)
{
    std::vector<std::vector<double>> times_ms(4);
    double frame_ms = 20.0;
    for (std::size_t round = 0; round < 30; ++round)
        for (const std::size_t i : roundOrder(4, round))
            times_ms[i].push_back(frame_ms += 0.2);
    for (const auto& input : times_ms)
        EXPECT_NEAR(median(input) / median(times_ms[0]), 1.0, 1e-12);
}

} // namespace dioptre
