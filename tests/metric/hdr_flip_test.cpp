// HDR-FLIP: its exposures, its curve, and the worst of all exposures.
#include "metric/flip.h"
#include "metric/hdr_flip.h"

#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// 2.11887 is what the curve maps to 0.85: worked out apart, in Python, from the curve's quadratic.
constexpr double mappedTo085 = 2.1188723239873157;

const auto silent = [](double) {};

std::vector<float> errorsOf(const PicturePair& pair)
{
    return hdrFlip(pair, usualPixelsPerDegree, flipExposures(pair), silent);
}

// 20 by 10 pixels: most of them of one radiance, one row of another.
Painter mostly(float most, float row)
{
    return [=](int, int y) { return glm::vec3(y == 0 ? row : most); };
}

} // namespace

TEST(HdrFlip, Curve_IsNarkowiczsAtSixTenths)
{
    const double x = 0.6 * 0.5;
    EXPECT_NEAR(flipToneMapped(0.5), x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1e-14);
    EXPECT_NEAR(flipToneMapped(mappedTo085), 0.85, 1e-12);
    EXPECT_EQ(flipToneMapped(0.0), 0.0);
    for (const double bright : {1e3, 1e6, 1e30, 1e200})
        EXPECT_EQ(flipToneMapped(bright), 1.0);
}

// Brightest 16 and median 1/4: 6 stops apart, so 6 exposures from log2(2.119 / 16) to log2(2.119 / 0.25).
TEST(HdrFlip, Exposures_RunFromTheBrightestToTheMedian)
{
    const ExposureRange range = flipExposures(pairOf(20, 10, mostly(0.25f, 16.0f), mostly(9, 9)));
    EXPECT_NEAR(range.start, std::log2(mappedTo085 / 16.0), 1e-9);
    EXPECT_NEAR(range.stop, std::log2(mappedTo085 / 0.25), 1e-9);
    EXPECT_EQ(range.count, 6);
}

TEST(HdrFlip, AUniformReference_HasTwoExposuresThatAreOne)
{
    const ExposureRange range = flipExposures(pairOf(4, 4, mostly(3, 3), mostly(1, 2)));
    EXPECT_NEAR(range.start, std::log2(mappedTo085 / 3.0), 1e-9);
    EXPECT_EQ(range.start, range.stop);
    EXPECT_EQ(range.count, 2);
}

// A median of 0, or below, has no exposure: that of what shines stands in, then the picture.
TEST(HdrFlip, BlackReferences_HaveFiniteExposures)
{
    const ExposureRange mostlyBlack = flipExposures(pairOf(20, 10, mostly(-1.0f, 2.0f), mostly(1, 1)));
    EXPECT_NEAR(mostlyBlack.start, std::log2(mappedTo085 / 2.0), 1e-9);
    EXPECT_NEAR(mostlyBlack.stop, std::log2(mappedTo085 / 2.0), 1e-9);
    const ExposureRange black = flipExposures(pairOf(4, 4, mostly(0, 0), mostly(0.5f, 0.5f)));
    EXPECT_NEAR(black.start, std::log2(mappedTo085 / 0.5), 1e-9);
    const ExposureRange both = flipExposures(pairOf(4, 4, mostly(0, 0), mostly(0, 0)));
    EXPECT_EQ(both.start, 0.0);
    EXPECT_EQ(both.stop, 0.0);
}

TEST(HdrFlip, PixelsThatAreNotFinite_ChangeNoExposure)
{
    const auto holed = [](int x, int y) {
        return x < 18 ? glm::vec3(x % 2 == 0 ? NAN : HUGE_VALF) : mostly(0.25f, 16.0f)(x, y);
    };
    const ExposureRange range = flipExposures(pairOf(20, 10, holed, mostly(1, 1)));
    EXPECT_NEAR(range.start, std::log2(mappedTo085 / 16.0), 1e-9);
    EXPECT_NEAR(range.stop, std::log2(mappedTo085 / 0.25), 1e-9);
}

TEST(HdrFlip, EqualPictures_DifferNowhere)
{
    for (const float error : errorsOf(pairOf(30, 20, noise(1, 100.0f), noise(1, 100.0f))))
        EXPECT_EQ(error, 0.0f);
}

// A picture and its reference, both twice as bright: the exposures are one stop lower, and all else is the
// same.
TEST(HdrFlip, TheUnitOfRadiance_DoesNotMatter)
{
    PicturePair pair = pairOf(30, 20, noise(1, 100.0f), noise(2, 90.0f));
    const std::vector<float> before = errorsOf(pair);
    for (auto* colours : {&pair.reference, &pair.picture})
        for (auto& colour : *colours)
            colour *= 2.0f;
    const std::vector<float> after = errorsOf(pair);
    for (std::size_t i = 0; i < before.size(); ++i)
        ASSERT_NEAR(before[i], after[i], 1e-6f) << i;
}

// The map is at least that of each exposure, and somewhere that of the first and of the last.
TEST(HdrFlip, EachPixel_HasTheWorstOfAllExposures)
{
    const auto reference = [](int x, int) { return glm::vec3(x < 20 ? 50.0f : 0.1f); };
    const auto picture = [](int x, int) { return glm::vec3(x < 20 ? 70.0f : 0.12f); };
    const PicturePair pair = pairOf(60, 12, reference, picture);
    const ExposureRange range = flipExposures(pair);
    ASSERT_GE(range.count, 8);
    const std::vector<float> worst = errorsOf(pair);
    std::vector<float> most(worst.size());
    for (int i = 0; i < range.count; ++i) {
        const double exposure = range.start + i * (range.stop - range.start) / (range.count - 1);
        PicturePair shown = pair;
        for (auto* colours : {&shown.reference, &shown.picture})
            for (auto& colour : *colours)
                for (int channel = 0; channel < 3; ++channel)
                    colour[channel] = static_cast<float>(
                        flipToneMapped(std::exp2(exposure) * static_cast<double>(colour[channel])));
        const std::vector<float> errors = ldrFlip(shown, usualPixelsPerDegree);
        for (std::size_t pixel = 0; pixel < most.size(); ++pixel)
            most[pixel] = std::max(most[pixel], errors[pixel]);
    }
    EXPECT_EQ(worst, most);
    // What an exposure for the bright half hides in the dark half, and the other way round, both show.
    EXPECT_GT(worst[5], 0.05f);
    EXPECT_GT(worst[55], 0.05f);
}

TEST(HdrFlip, Progress_EndsAtOneAndMayStopTheWork)
{
    const PicturePair pair = pairOf(12, 12, noise(1, 100.0f), noise(2, 100.0f));
    double told = 0.0;
    hdrFlip(pair, usualPixelsPerDegree, {-3.0, 3.0, 6}, [&](double share) {
        EXPECT_GT(share, told);
        told = share;
    });
    EXPECT_EQ(told, 1.0);
    EXPECT_THROW(hdrFlip(pair, usualPixelsPerDegree, {-3.0, 3.0, 6}, [](double) { throw 1; }), int);
}
