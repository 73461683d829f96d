// LDR-FLIP against the paper's sums, closed forms, and what any such measure must keep to.
#include "metric/flip.h"

#include "direct_flip.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

double meanOf(const PicturePair& pair, double pixelsPerDegree = usualPixelsPerDegree)
{
    return pooled(ldrFlip(pair, pixelsPerDegree), pair.judged).mean;
}

// Black to the left of the column, white from there on.
Painter blackAndWhite(int column)
{
    return [column](int x, int) { return glm::vec3(x < column ? 0.0f : 1.0f); };
}

} // namespace

TEST(LdrFlip, EqualPictures_DifferNowhere)
{
    const PicturePair pair = pairOf(50, 40, noise(1), noise(1));
    for (const float error : ldrFlip(pair, usualPixelsPerDegree))
        EXPECT_EQ(error, 0.0f);
}

// Whatever the filters, a uniform picture stays as it is and has no features.
TEST(LdrFlip, UniformPictures_DifferByTheirColoursAlone)
{
    const auto expectEverywhere = [](const glm::vec3& a, const glm::vec3& b, float error) {
        for (const float found : ldrFlip(pairOf(90, 70, uniform(a), uniform(b)), usualPixelsPerDegree))
            ASSERT_NEAR(found, error, 1e-6f);
    };
    expectEverywhere({0, 1, 0}, {0, 0, 1}, 1.0f);
    expectEverywhere({0, 0, 0}, {1, 1, 1}, 0.9673798f); // derived in flip_colour_test.cpp
    expectEverywhere({1, 0, 0}, {0, 1, 0}, 0.9866623f); // worked out apart, as those were
}

// Pixels of corners, edges, the inside, and on both sides of where the picture's bands meet.
TEST(LdrFlip, RandomPictures_DifferByThePapersSums)
{
    const int width = 37, height = 140;
    const auto lines = [paint = noise(8)](int x, int y) {
        const glm::vec3 colour = paint(x, y);
        return x % 7 < 3 || y % 11 == 0 ? 0.3f * colour : colour;
    };
    const PicturePair pair = pairOf(width, height, noise(7), lines);
    for (const double pixelsPerDegree : {67.0, 23.5, 5.0}) {
        const std::vector<float> errors = ldrFlip(pair, pixelsPerDegree);
        const DirectFlip direct(width, height, pixelsPerDegree);
        for (const int y : {0, 5, 62, 63, 64, 127, 128, 139})
            for (const int x : {0, 9, 18, 36})
                EXPECT_NEAR(errors[static_cast<std::size_t>(y * width + x)], direct.error(pair, x, y), 2e-6)
                    << x << " " << y << " at " << pixelsPerDegree;
    }
}

TEST(LdrFlip, SmoothPictures_DifferByThePapersSums)
{
    const auto smooth = [](float phase) {
        return [phase](int x, int y) {
            const auto u = static_cast<float>(x), v = static_cast<float>(y);
            return 0.5f +
                   0.4f * glm::vec3(std::sin(0.1f * u + phase), std::cos(0.15f * v), std::sin(0.2f * u));
        };
    };
    const PicturePair pair = pairOf(60, 30, smooth(0.0f), smooth(0.4f));
    const std::vector<float> errors = ldrFlip(pair, usualPixelsPerDegree);
    const DirectFlip direct(60, 30, usualPixelsPerDegree);
    for (const int x : {0, 13, 31, 59})
        EXPECT_NEAR(errors[static_cast<std::size_t>(12 * 60 + x)], direct.error(pair, x, 12), 2e-6) << x;
}

TEST(LdrFlip, Order_DoesNotMatter)
{
    const PicturePair there = pairOf(30, 20, noise(1), noise(2)), back = pairOf(30, 20, noise(2), noise(1));
    EXPECT_EQ(ldrFlip(there, usualPixelsPerDegree), ldrFlip(back, usualPixelsPerDegree));
}

TEST(LdrFlip, APictureTurned_HasItsErrorsTurned)
{
    const PicturePair pair = pairOf(25, 70, noise(1), noise(2));
    PicturePair turned = pair;
    std::ranges::reverse(turned.reference);
    std::ranges::reverse(turned.picture);
    std::vector<float> errors = ldrFlip(pair, usualPixelsPerDegree);
    std::ranges::reverse(errors);
    const std::vector<float> errorsTurned = ldrFlip(turned, usualPixelsPerDegree);
    for (std::size_t i = 0; i < errors.size(); ++i)
        ASSERT_NEAR(errors[i], errorsTurned[i], 1e-6f) << i;
}

TEST(LdrFlip, LargerDifferences_AreLargerErrors)
{
    double before = 0.0;
    for (const float amount : {0.01f, 0.03f, 0.1f, 0.3f, 0.7f}) {
        const double now =
            meanOf(pairOf(40, 40, uniform(glm::vec3(0.2f)), uniform(glm::vec3(0.2f + amount))));
        EXPECT_GT(now, before) << amount;
        before = now;
    }
}

// A shifted edge is a difference in features too, so there the error is larger than by colours alone.
TEST(LdrFlip, EdgesThatMoved_AreSeenWhereTheyAre)
{
    const PicturePair pair = pairOf(80, 9, blackAndWhite(40), blackAndWhite(42));
    const std::vector<float> errors = ldrFlip(pair, usualPixelsPerDegree);
    const std::size_t row = 4 * 80;
    EXPECT_GT(errors[row + 40], 0.7f);
    EXPECT_LT(errors[row + 10], 1e-6f);
    EXPECT_LT(errors[row + 70], 1e-6f);
}

// From afar the eye averages noise away.
TEST(LdrFlip, MorePixelsADegree_HideFineNoise)
{
    const PicturePair pair = pairOf(60, 60, uniform(glm::vec3(0.3f)), noise(3, 0.6f));
    EXPECT_LT(meanOf(pair, 200.0), meanOf(pair, 67.0));
    EXPECT_LT(meanOf(pair, 67.0), meanOf(pair, 20.0));
}

TEST(LdrFlip, OnePixel_IsAPictureToo)
{
    EXPECT_NEAR(meanOf(pairOf(1, 1, uniform({0, 1, 0}), uniform({0, 0, 1}))), 1.0, 1e-6);
}

// Sums: 0.1 + 0.2 + 0.3 + 0.9 = 1.5; half of it is passed by the 0.9 alone.
TEST(PooledFlip, FourErrors_GiveTheirMeanAndMedians)
{
    const PooledFlip four = pooled({0.9f, 0.1f, 0.3f, 0.2f, 0.99f}, {1, 1, 1, 1, 0});
    EXPECT_NEAR(four.mean, 0.375, 1e-7);
    EXPECT_NEAR(four.median, 0.25, 1e-7);
    EXPECT_NEAR(four.weightedMedian, 0.9, 1e-7);
    EXPECT_NEAR(four.max, 0.9, 1e-7);
    EXPECT_NEAR(pooled({0.5f, 0.1f, 0.2f}, {1, 1, 1}).median, 0.2, 1e-7);
    EXPECT_TRUE(std::isnan(pooled({0.5f}, {0}).mean));
    EXPECT_EQ(pooled({0.0f, 0.0f}, {1, 1}).weightedMedian, 0.0);
}
