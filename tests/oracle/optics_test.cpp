#include "oracle/optics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre
{
namespace
{

const std::array<double, 9> indices{0.01, 1.0 / 1.5, 0.75, 1.0 + 1e-6, 1.33, 1.5, 2.4, 10.0, 100.0};

void expectNear(const glm::dvec3& found, const glm::dvec3& known)
{
    EXPECT_LE(glm::length(found - known), 4e-16) << found.x << ", " << found.y << ", " << found.z;
}

} // namespace

TEST(Oracle_Fresnel, AtNormalIncidence_IsTheSquareOfDifferenceOverSum)
{
    EXPECT_DOUBLE_EQ(fresnelShares(1.0, 1.5).reflected, 0.04);
    EXPECT_DOUBLE_EQ(fresnelShares(1.0, 3.0).reflected, 0.25);
    EXPECT_DOUBLE_EQ(fresnelShares(1.0, 3.0).transmitted, 0.75);
    // The angles' formula tends there: its next term is of the angle's fourth power.
    EXPECT_NEAR(fresnelShares(std::cos(1e-4), 3.0).reflected, 0.25, 1e-15);
}

TEST(Oracle_Fresnel, ReflectedAndTransmitted_AreAllOfTheLight)
{
    for (const double index : indices)
        for (int i = 0; i <= 1000; ++i) {
            const FresnelShares shares = fresnelShares(i / 1000.0, index);
            EXPECT_NEAR(shares.reflected + shares.transmitted, 1.0, 3e-16) << index << " at " << i;
            EXPECT_GE(shares.reflected, 0.0);
            EXPECT_GE(shares.transmitted, 0.0);
        }
}

TEST(Oracle_Fresnel, AtBrewstersAngle_OneHalfOfTheLightIsNotReflected)
{
    // tan i = n = 3/4, cos i = 4/5: i + r is a right angle, and sin(i - r) = sin^2 i - cos^2 i... of the
    // other half.
    const double perpendicular = (0.75 * 0.75 - 1.0) / (0.75 * 0.75 + 1.0);
    EXPECT_NEAR(fresnelShares(0.8, 0.75).reflected, 0.5 * perpendicular * perpendicular, 1e-16);
    const double other = (1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0);
    EXPECT_NEAR(fresnelShares(1.0 / std::sqrt(1.0 + 1.5 * 1.5), 1.5).reflected, 0.5 * other * other, 1e-16);
}

TEST(Oracle_Fresnel, At60DegreesOntoGlass_IsFresnelsOwnForm)
{
    const double c = 0.5;
    const double refracted = std::sqrt(1.0 - 0.75 / 2.25);
    const double s = (c - 1.5 * refracted) / (c + 1.5 * refracted);
    const double p = (refracted - 1.5 * c) / (refracted + 1.5 * c);
    EXPECT_NEAR(fresnelShares(c, 1.5).reflected, 0.5 * (s * s + p * p), 1e-16);
}

TEST(Oracle_Fresnel, BeyondTheCriticalAngle_AllIsReflected_AndJustBeforeItNotQuite)
{
    // sin i = 0.6 at index 0.6; cos i is a double, and the nearest above 0.8 is a smaller angle.
    EXPECT_EQ(fresnelShares(0.7, 0.6).reflected, 1.0);
    EXPECT_EQ(fresnelShares(0.7, 0.6).transmitted, 0.0);
    const double critical = std::sqrt(1.0 - 0.36);
    const FresnelShares before = fresnelShares(critical + 1e-6, 0.6);
    // T = 2 cos r (1/n + n) / cos i to first order, with cos^2 r = 2 cos i 1e-6 / n^2.
    const double cosRefracted = std::sqrt(2.0 * critical * 1e-6) / 0.6;
    EXPECT_NEAR(before.transmitted, 2.0 * cosRefracted * (0.6 + 1.0 / 0.6) / critical,
                0.03 * before.transmitted);
    EXPECT_EQ(fresnelShares(critical - 1e-6, 0.6).reflected, 1.0);
}

TEST(Oracle_Fresnel, IsTheSameFromBothSides)
{
    for (const double c : {0.1, 0.5, 0.9, 0.999}) {
        const double refracted = std::sqrt(1.0 - (1.0 - c * c) / 2.25);
        EXPECT_NEAR(fresnelShares(c, 1.5).reflected, fresnelShares(refracted, 1.0 / 1.5).reflected, 2e-15);
    }
}

TEST(Oracle_Fresnel, GrazingReflectsAll_AndIndex1Nothing)
{
    EXPECT_DOUBLE_EQ(fresnelShares(0.0, 1.5).reflected, 1.0);
    for (const double c : {0.0, 0.5, 1.0}) {
        EXPECT_EQ(fresnelShares(c, 1.0).reflected, 0.0);
        EXPECT_EQ(fresnelShares(c, 1.0).transmitted, 1.0);
    }
    // n = 1 + e reflects e^2 / 4 head-on.
    EXPECT_NEAR(fresnelShares(1.0, 1.0 + 0x1p-20).reflected / (0x1p-40 / 4.0), 1.0, 1e-6);
}

TEST(Oracle_Snell, TheSinesOfA345Triangle_ChangePlaces)
{
    expectNear(*snellDirection({3, -4, 0}, {0, 1, 0}, 0.75), {0.8, -0.6, 0});
    expectNear(*snellDirection({3, -4, 0}, {0, -7, 0}, 0.75),
               {0.8, -0.6, 0}); // the normal's side and length do not matter
    expectNear(*snellDirection({0, 8, 6}, {0, 0, 1}, 4.0 / 3.0), {0, 0.6, 0.8});
    expectNear(*snellDirection({0, 0, -2}, {0, 0, 1}, 1.5), {0, 0, -1});
}

TEST(Oracle_Snell, BeyondTheCriticalAngle_NoDirectionIsLeft)
{
    EXPECT_FALSE(snellDirection({4, -3, 0}, {0, 1, 0}, 0.75));
    EXPECT_TRUE(snellDirection({4, -3, 0}, {0, 1, 0}, 0.81));
}

TEST(Oracle_Snell, GoingBack_EndsWhereItBegan)
{
    for (const double index : indices) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 3));
        const glm::dvec3 direction = glm::normalize(glm::dvec3(-1.0, -2.0, -3.004));
        const auto refracted = snellDirection(direction, normal, index);
        ASSERT_TRUE(refracted);
        EXPECT_LE(glm::length(*snellDirection(*refracted, normal, 1.0 / index) - direction), 1e-14);
    }
}

TEST(Oracle_Mirror, ThePartAlongTheNormal_ChangesItsSign)
{
    expectNear(mirroredDirection({3, -4, 0}, {0, 2, 0}), {0.6, 0.8, 0});
    expectNear(mirroredDirection({3, 4, 0}, {0, 2, 0}), {0.6, -0.8, 0});
    expectNear(mirroredDirection({0, 0, -5}, {0, 0, 1}), {0, 0, 1});
    expectNear(mirroredDirection({1, 0, 0}, {-1, 1, 0}), {0, 1, 0});
}

} // namespace dioptre
