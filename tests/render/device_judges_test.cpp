// What the host makes of a device's answers, with answers made up: good ones, and the ways in which drivers
// are wrong.
#include "render/device_scene.h"
#include "render/exact_arithmetic.h"
#include "render/loop_canary.h"
#include "render/probe.h"
#include "render/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace dioptre;

namespace
{

// As a device with float32 arithmetic and no liberties gives them; the host's fma rounds once.
std::vector<float> goodAnswers(const std::vector<FloatPair>& pairs)
{
    std::vector<float> answers;
    for (const auto& [a, b] : pairs) {
        const float sum = a + b;
        const float bRounded = sum - a;
        const float product = a * b;
        answers.insert(answers.end(),
                       {sum, (a - (sum - bRounded)) + (b - bRounded), product, std::fma(a, b, -product)});
    }
    return answers;
}

// Good answers with every one of the four results put through `change` in turn.
template <class Change>
ExactTally judgeChanged(std::size_t channel, Change change)
{
    const auto pairs = exactTestPairs();
    auto answers = goodAnswers(pairs);
    for (std::size_t i = channel; i < answers.size(); i += 4)
        answers[i] = change(answers[i]);
    return judgeExact(pairs, answers);
}

constexpr float infinite = std::numeric_limits<float>::infinity();

} // namespace

TEST(ExactTestPairs, SpanManyDecadesWithExactNormalErrors)
{
    const auto pairs = exactTestPairs();
    EXPECT_EQ(pairs.size(), 65536U);
    double least = 1.0, most = 1.0;
    std::size_t lossySums = 0, lossyProducts = 0;
    const auto answers = goodAnswers(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (const float number : {pairs[i].a, pairs[i].b}) {
            least = std::min(least, static_cast<double>(std::abs(number)));
            most = std::max(most, static_cast<double>(std::abs(number)));
        }
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_TRUE(answers[4 * i + c] == 0.0F || std::isnormal(answers[4 * i + c]))
                << pairs[i].a << " " << pairs[i].b;
        lossySums += answers[4 * i + 1] != 0.0F ? 1 : 0;
        lossyProducts += answers[4 * i + 3] != 0.0F ? 1 : 0;
    }
    EXPECT_GT(std::log10(most / least), 22.0);
    EXPECT_GT(lossySums, pairs.size() * 9 / 10) << "a pair that loses nothing proves nothing";
    EXPECT_GT(lossyProducts, pairs.size() * 9 / 10);
}

TEST(JudgeExact, RightAnswers_AreRight)
{
    const auto pairs = exactTestPairs();
    const ExactTally tally = judgeExact(pairs, goodAnswers(pairs));
    EXPECT_TRUE(tally.right()) << tally.twoSum.wrong << " " << tally.twoProduct.wrong;
    EXPECT_EQ(tally.twoSum.tested, pairs.size());
    EXPECT_EQ(tally.twoProduct.tested, pairs.size());
}

// What a compiler makes of (a - (s - (s - a))) + (b - (s - a)) when it may regroup, and of fma(a, b, -p) when
// it rounds twice.
TEST(JudgeExact, ErrorsThatVanished_AreWrongWhereverSomethingWasLost)
{
    const ExactTally sums = judgeChanged(1, [](float) { return 0.0F; });
    EXPECT_GT(sums.twoSum.wrong, 50000U);
    EXPECT_EQ(sums.twoProduct.wrong, 0U);
    const ExactTally products = judgeChanged(3, [](float) { return 0.0F; });
    EXPECT_EQ(products.twoSum.wrong, 0U);
    EXPECT_GT(products.twoProduct.wrong, 50000U);
}

TEST(JudgeExact, AnyResultOffByItsLastBit_IsWrong)
{
    for (const std::size_t channel : {0U, 1U, 2U, 3U}) {
        const ExactTally tally = judgeChanged(channel, [](float x) { return std::nextafter(x, infinite); });
        const Tally& changed = channel < 2 ? tally.twoSum : tally.twoProduct;
        EXPECT_EQ(changed.wrong, changed.tested) << channel;
    }
}

TEST(JudgeExact, NaN_IsWrong)
{
    const ExactTally tally = judgeChanged(1, [](float) { return std::numeric_limits<float>::quiet_NaN(); });
    EXPECT_EQ(tally.twoSum.wrong, tally.twoSum.tested);
}

TEST(Guard, IsPreciseThenTheUniformThenNone)
{
    const Tally right{10, 0}, wrong{10, 1}, absent{0, 0};
    const auto guard = [](Tally precise, Tally unit, Tally product) {
        ExactArithmetic arithmetic;
        arithmetic.precise = {precise, product};
        arithmetic.unit = {unit, product};
        return guardOf(arithmetic);
    };
    EXPECT_EQ(guard(right, right, right), Guard::precise);
    EXPECT_EQ(guard(absent, right, right), Guard::unit);
    EXPECT_EQ(guard(wrong, right, right), Guard::unit);
    EXPECT_EQ(guard(absent, wrong, right), Guard::none);
    EXPECT_EQ(guard(right, right, wrong), Guard::none) << "kernels need both";
}

TEST(LoopsSuffice, WhereNoCapOrTheKnownOneIsFound)
{
    const auto canary = [](long ran, bool faithful) {
        LoopCanary made;
        made.asked = 262144;
        made.ran = ran;
        made.faithful = faithful;
        return made;
    };
    EXPECT_TRUE(loopsSuffice(canary(262144, true), true));
    EXPECT_TRUE(loopsSuffice(canary(262144, true), false));
    EXPECT_TRUE(loopsSuffice(canary(softwareLoopCap, true), true));
    EXPECT_FALSE(loopsSuffice(canary(softwareLoopCap - 1, true), true)) << "a full sample would be cut";
    EXPECT_FALSE(loopsSuffice(canary(softwareLoopCap, true), false)) << "nothing bounds a sample there";
    EXPECT_FALSE(loopsSuffice(canary(262144, false), true)) << "counts without the work";
}

TEST(Clocks, QueriesHoldWhereTheyTellMostOfTheTime)
{
    EXPECT_TRUE((Clocks{10.0, 9.5}.queriesHold()));
    EXPECT_FALSE((Clocks{75.0, 2.0}.queriesHold()));
}

// 64 KiB: materials of 12, lights of 6 vectors of 16 bytes; objects of 5 behind a head of 8.
TEST(BlockCapacity, IsWhatFitsInABlock)
{
    const BlockCapacity capacity = capacityOf(65536);
    EXPECT_EQ(capacity.materials, 341U);
    EXPECT_EQ(capacity.lights, 682U);
    EXPECT_EQ(capacity.tableObjects, 817U);
    EXPECT_EQ(capacityOf(0).tableObjects, 0U);
}
