// Errors of radiance against sums by hand.
#include "metric/linear_error.h"

#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();

} // namespace

TEST(LinearError, EqualPictures_HaveNone)
{
    const LinearError error = linearError(pairOf(7, 5, noise(1, 50.0f), noise(1, 50.0f)));
    EXPECT_EQ(error.rmse, 0.0);
    EXPECT_EQ(error.mae, 0.0);
    EXPECT_EQ(error.relmse, 0.0);
    EXPECT_EQ(error.max, 0.0);
}

// 6 pixels, 18 numbers; one is off by 3 where the reference is 0.49, one by -4 where it is 7.99.
TEST(LinearError, TwoNumbersOff_GiveTheSumsByHand)
{
    const auto reference = [](int x, int y) {
        return x == 2 && y == 1 ? glm::vec3(0.49f, 1, 1) : glm::vec3(1, 1, 7.99f);
    };
    const auto picture = [&](int x, int y) {
        glm::vec3 colour = reference(x, y);
        if (x == 2 && y == 1)
            colour.r += 3.0f;
        if (x == 1 && y == 0)
            colour.b -= 4.0f;
        return colour;
    };
    const LinearError error = linearError(pairOf(3, 2, reference, picture));
    EXPECT_NEAR(error.rmse, std::sqrt((9.0 + 16.0) / 18.0), 1e-7);
    EXPECT_NEAR(error.mae, 7.0 / 18.0, 1e-7);
    EXPECT_NEAR(error.relmse, (9.0 / 0.25 + 16.0 / 64.0) / 18.0, 1e-6); // (r + 0.01)^2 is 0.25 and 64
    EXPECT_NEAR(error.max, 4.0, 1e-6);
    EXPECT_EQ(error.maxX_px, 1);
    EXPECT_EQ(error.maxY_px, 1); // row 0 of the picture is its lowest, the second from the top
}

TEST(LinearError, RadianceBeyondOne_IsNotClamped)
{
    const LinearError error = linearError(pairOf(2, 2, uniform({100, 100, 100}), uniform({90, 90, 90})));
    EXPECT_DOUBLE_EQ(error.rmse, 10.0);
    EXPECT_DOUBLE_EQ(error.max, 10.0);
}

// The first in the order of reading: the upper left one.
TEST(LinearError, OfEqualErrors_TheUpperLeftIsNamed)
{
    const LinearError error = linearError(pairOf(4, 3, uniform({0, 0, 0}), uniform({1, 1, 1})));
    EXPECT_EQ(error.maxX_px, 0);
    EXPECT_EQ(error.maxY_px, 0);
}

TEST(LinearError, NegativeReference_CountsByItsMagnitude)
{
    const glm::vec3 negative(-0.01f); // r + 0.01 would be 0, or a rounding error
    const LinearError error = linearError(pairOf(1, 1, uniform(negative), uniform(glm::vec3(0.01f))));
    EXPECT_NEAR(error.relmse, 1.0, 1e-6);
}

TEST(LinearError, PixelsThatAreNotFinite_AreCountedAndLeftOut)
{
    const auto reference = [](int x, int y) {
        return x == 0 && y == 0 ? glm::vec3(0, NAN, 0) : x == 1 ? glm::vec3(infinity) : glm::vec3(1);
    };
    const auto picture = [](int x, int) { return x == 0 ? glm::vec3(-infinity, 0, 0) : glm::vec3(3); };
    const PicturePair pair = pairOf(3, 2, reference, picture);
    EXPECT_EQ(pair.nonfiniteReference, 3U);
    EXPECT_EQ(pair.nonfinitePicture, 2U);
    EXPECT_EQ(pair.judged, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 1}));
    const LinearError error = linearError(pair);
    EXPECT_DOUBLE_EQ(error.rmse, 2.0); // of the last column alone
    EXPECT_DOUBLE_EQ(error.max, 2.0);
}

TEST(LinearError, NothingToJudge_IsUndefined)
{
    const LinearError error = linearError(pairOf(2, 2, uniform(glm::vec3(NAN)), uniform({1, 1, 1})));
    EXPECT_TRUE(std::isnan(error.rmse));
    EXPECT_TRUE(std::isnan(error.mae));
    EXPECT_TRUE(std::isnan(error.relmse));
    EXPECT_TRUE(std::isnan(error.max));
}

TEST(Pair, EightBits_AreDecodedAsTheirFormatSays)
{
    const Picture srgb{1, 1, PixelFormat::srgb8, {188, 0, 255, 255}, {}};
    const Picture linear{1, 1, PixelFormat::linear8, {188, 0, 255, 255}, {}};
    const PicturePair pair = dioptre::pairOf(srgb, linear);
    EXPECT_NEAR(pair.reference[0].r, 0.502886, 1e-6); // ((188/255 + 0.055) / 1.055)^2.4
    EXPECT_NEAR(pair.picture[0].r, 188.0 / 255.0, 1e-7);
    EXPECT_EQ(pair.reference[0].b, 1.0f);
    EXPECT_EQ(pair.picture[0].g, 0.0f);
}

TEST(Pair, WhatADisplayShows_IsExposedAndCutToItsRange)
{
    const PicturePair pair = pairOf(1, 1, uniform({0.25f, -1.0f, 8.0f}), uniform({0.25f, 0.5f, 8.0f}));
    const PicturePair shown = displayed(pair, {.exposure = 1.0}, {});
    EXPECT_EQ(shown.reference[0], glm::vec3(0.5f, 0.0f, 1.0f));
    EXPECT_EQ(shown.picture[0], glm::vec3(0.25f, 0.5f, 1.0f));
    const PicturePair sent = encoded(shown);
    EXPECT_NEAR(sent.reference[0].r, 0.735357, 1e-6); // 1.055 * 0.5^(1/2.4) - 0.055
    EXPECT_EQ(sent.reference[0].b, 1.0f);
}
