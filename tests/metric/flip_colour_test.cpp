// FLIP's colour spaces against the definitions of sRGB and CIELAB and the paper's own numbers.
#include "metric/flip_colour.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace dioptre;

namespace
{

const glm::dvec3 black(0), white(1), red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1);

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

} // namespace

TEST(FlipColour, WhiteAndBlack_AreTheEndsOfEachSpace)
{
    expectNear(whiteRelativeXyz(white), {1, 1, 1}, 1e-15);
    expectNear(opponentFromRgb(white), {100, 0, 0}, 1e-12);
    expectNear(opponentFromRgb(black), {-16, 0, 0}, 1e-15);
    expectNear(huntLabFromRgb(white), {100, 0, 0}, 1e-12);
    expectNear(huntLabFromRgb(black), {0, 0, 0}, 1e-12);
}

// The matrix as quotients of whole numbers (image-engineering.de, technote 958), which FLIP's authors use.
TEST(FlipColour, Primaries_AreThoseOfThePublishedMatrix)
{
    const glm::dvec3 reference(0.950428545, 1.0, 1.088900371); // their white
    expectNear(whiteRelativeXyz(red) * reference,
               {10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0}, 1e-9);
    expectNear(whiteRelativeXyz(green) * reference,
               {8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0}, 1e-9);
    expectNear(whiteRelativeXyz(blue) * reference,
               {4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0}, 1e-9);
}

TEST(FlipColour, OpponentsAndBack_IsTheSameColour)
{
    for (const glm::dvec3& colour : {black, white, red, glm::dvec3(0.2, 0.7, 0.4)})
        expectNear(rgbFromOpponent(opponentFromRgb(colour)), colour, 1e-13);
}

// Y = 0.18 gives L* = 116 * 0.18^(1/3) - 16; below (6/29)^3 it is 903.3 Y.
TEST(FlipColour, Lightness_IsThatOfCielab)
{
    EXPECT_NEAR(huntLabFromRgb(glm::dvec3(0.18)).x, 116.0 * std::cbrt(0.18) - 16.0, 1e-12);
    EXPECT_NEAR(huntLabFromRgb(glm::dvec3(0.001)).x, 0.001 * 24389.0 / 27.0, 1e-12);
}

// Lab of green: 87.736, -86.179, 83.183 at this white.
TEST(FlipColour, Chroma_IsScaledByLightness)
{
    const glm::dvec3 lab = huntLabFromRgb(green);
    const glm::dvec3 xyz = whiteRelativeXyz(green);
    EXPECT_NEAR(lab.y, 0.01 * lab.x * 500.0 * (std::cbrt(xyz.x) - std::cbrt(xyz.y)), 1e-12);
    EXPECT_LT(lab.y, -75.0);
    EXPECT_GT(lab.z, 72.0);
}

// Worked out apart, in Python, from the paper's equations and the published matrix: HyAB(green, blue) is
// 203.30165, to the power 0.7 it is 41.276.
TEST(FlipColour, LargestDifference_IsThatOfGreenAndBlue)
{
    EXPECT_NEAR(hyab(huntLabFromRgb(green), huntLabFromRgb(blue)), 203.3016546, 1e-6);
    EXPECT_NEAR(colourDifference(green, blue), 1.0, 1e-15);
    for (const glm::dvec3& some : {black, white, red, green, blue, glm::dvec3(1, 1, 0), glm::dvec3(1, 0, 1)})
        for (const glm::dvec3& other : {black, white, red, green, blue, glm::dvec3(0, 1, 1)})
            EXPECT_LE(colourDifference(some, other), 1.0 + 1e-15);
}

// 100^0.7 over 41.276 is 0.608556; beyond 0.4 that is stretched to 0.95 + 0.05 (0.608556 - 0.4) / 0.6.
TEST(FlipColour, BlackAndWhite_DifferByThePapersAmount)
{
    const double share = std::pow(100.0 / 203.3016546108775, 0.7);
    EXPECT_NEAR(colourDifference(black, white), 0.95 + 0.05 * (share - 0.4) / 0.6, 1e-12);
    EXPECT_NEAR(colourDifference(black, white), 0.9673797615, 1e-10);
    EXPECT_NEAR(colourDifference(glm::dvec3(0.5), glm::dvec3(0.51)), 0.0406977342, 1e-8);
    EXPECT_EQ(colourDifference(red, red), 0.0);
}
