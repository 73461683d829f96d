#include "oracle/shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

const double pi = std::acos(-1.0);

} // namespace

TEST(Oracle_Microfacets, AtTheirPeak_HaveTheDensity1OverPiAlphaSquared)
{
    EXPECT_DOUBLE_EQ(microfacetDensity({0, 0, 2}, {0, 0, 3}, 0.25), 16.0 / pi);
    EXPECT_DOUBLE_EQ(microfacetDensity({1, 2, 3}, {1, 2, 3}, 0x1p-14), 0x1p28 / pi);
}

TEST(Oracle_Microfacets, At45Degrees_AreWalters)
{
    // tan = 1, cos^4 = 1/4, alpha = 1/2: 1 / (pi/16 (1 + 4)^2).
    EXPECT_DOUBLE_EQ(microfacetDensity({0, 1, 0}, {0, 1, 1}, 0.5), 16.0 / (25.0 * pi));
    EXPECT_EQ(microfacetDensity({0, 1, 0}, {0, 0, 1}, 0.5), 0.0);
    EXPECT_EQ(microfacetDensity({0, 1, 0}, {0, -1, 1}, 0.5), 0.0);
}

TEST(Oracle_Microfacets, CoverTheSurfaceOnce)
{
    // The integral of D cos over the hemisphere is 1: Walter et al., eq. 4.
    double area = 0.0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double angle = (i + 0.5) / steps * pi / 2.0;
        const double density = microfacetDensity({0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, 0.3);
        area += density * std::cos(angle) * 2.0 * pi * std::sin(angle) * (pi / 2.0 / steps);
    }
    EXPECT_NEAR(area, 1.0, 1e-7);
}

TEST(Oracle_Lobe, IsAPowerOfTheCosine)
{
    const glm::dvec3 at60(std::sqrt(3.0), 1, 0);
    EXPECT_NEAR(cosineLobe({0, 5, 0}, at60, 2.0), 0.25, 1e-16);
    EXPECT_EQ(cosineLobe({0, 5, 0}, at60, 0.0), 1.0);
    EXPECT_EQ(cosineLobe({0, 1, 0}, {0, 3, 0}, 1e5), 1.0);
    EXPECT_EQ(cosineLobe({0, 1, 0}, {1, 0, 0}, 3.0), 0.0);
    EXPECT_EQ(cosineLobe({0, 1, 0}, {0, -1, 0}, 2.0), 0.0);
    // Near the peak of exponent 1e5: cos^2 = 1 / (1 + tan^2).
    const double tangent = 1e-3;
    EXPECT_NEAR(cosineLobe({0, 1, 0}, {tangent, 1, 0}, 1e5), std::exp(-0.5e5 * std::log1p(tangent * tangent)),
                1e-14);
}

TEST(Oracle_Spot, LightsItsCone_TheRimIncluded)
{
    const glm::dvec3 axis(0, -2, 0);
    const double at45 = std::atan2(1.0, 1.0);
    EXPECT_TRUE(spotCone(axis, {0.999, -1, 0}, at45, 2.0).inside);
    EXPECT_FALSE(spotCone(axis, {1.001, -1, 0}, at45, 2.0).inside);
    EXPECT_EQ(spotCone(axis, {1.001, -1, 0}, at45, 2.0).strength, 0.0);
    EXPECT_TRUE(spotCone(axis, {0, -1, 0}, 0.0, 2.0).inside);
    EXPECT_NEAR(spotCone(axis, {3, -4, 0}, at45, 2.0).strength, 0.64, 1e-16);
    EXPECT_EQ(spotCone(axis, {3, -4, 0}, at45, 0.0).strength, 1.0);
    EXPECT_EQ(spotCone(axis, {1, 1, 0}, pi, 0.0).strength, 1.0); // all around
    // A cone of a microradian: its own cosine is 1 in float.
    EXPECT_TRUE(spotCone(axis, {0.99e-6, -1, 0}, 1e-6, 1.0).inside);
    EXPECT_FALSE(spotCone(axis, {1.01e-6, -1, 0}, 1e-6, 1.0).inside);
}

TEST(Oracle_Attenuation, FallsWithDistance_ButNotNearerThanTheLight)
{
    EXPECT_DOUBLE_EQ(attenuationAt({1, 2, 0.5}, 3.0, 1e-3), 1.0 / 11.5);
    EXPECT_DOUBLE_EQ(attenuationAt({0, 0, 1}, 0.0, 1e-3), 1e6);
    EXPECT_DOUBLE_EQ(attenuationAt({0, 0, 1}, 1e6, 1e-3), 1e-12);
}

TEST(Oracle_LatLong, TheAxes_LieWhereTheMapHasThem)
{
    EXPECT_EQ(latLongPlace({0, 0, 3}), glm::dvec2(0.5, 0.5));
    EXPECT_EQ(latLongPlace({3, 0, 0}), glm::dvec2(0.75, 0.5));
    EXPECT_EQ(latLongPlace({-3, 0, 0}), glm::dvec2(0.25, 0.5));
    EXPECT_EQ(latLongPlace({0, 3, 0}), glm::dvec2(0.5, 1.0));
    EXPECT_EQ(latLongPlace({0, -3, 0}), glm::dvec2(0.5, 0.0));
    EXPECT_EQ(latLongPlace({0, 1, 1}), glm::dvec2(0.5, 0.75));
    EXPECT_EQ(latLongPlace({1, 0, -1}), glm::dvec2(0.875, 0.5));
}

TEST(Oracle_LatLong, NearAPole_KeepsItsDigits)
{
    // 1e-9 from the pole: v falls short of 1 by 1e-9 / pi, as a double to 1e-16.
    EXPECT_NEAR((1.0 - latLongPlace({1e-9, 1, 0}).y) * pi, 1e-9, 4e-16);
}

TEST(Oracle_Display, EncodesByTheSrgbCurve)
{
    EXPECT_EQ(displayValue(0.0, {}), 0.0);
    EXPECT_DOUBLE_EQ(displayValue(1.0, {}), 1.0);
    EXPECT_DOUBLE_EQ(displayValue(0.002, {}), 12.92 * 0.002);
    EXPECT_DOUBLE_EQ(displayValue(0.5, {}), 1.055 * std::pow(0.5, 1.0 / 2.4) - 0.055);
    EXPECT_DOUBLE_EQ(displayValue(0.125, {.exposure = 2.0}), displayValue(0.5, {}));
    EXPECT_DOUBLE_EQ(displayValue(0.25, {.exposure = 0.0, .curve = ToneCurve::none, .gamma = 2.0}), 0.5);
    EXPECT_EQ(displayValue(0.0, {.exposure = 0.0, .curve = ToneCurve::none, .gamma = 2.2}), 0.0);
}

TEST(Oracle_Display, Curves_AreTheirFormulas)
{
    const Display reinhard{.exposure = 0.0, .curve = ToneCurve::reinhard, .gamma = 1.0};
    EXPECT_DOUBLE_EQ(displayValue(1.0, reinhard), 0.5);
    EXPECT_DOUBLE_EQ(displayValue(3.0, reinhard), 0.75);
    const Display filmic{.exposure = 0.0, .curve = ToneCurve::filmic, .gamma = 1.0};
    EXPECT_DOUBLE_EQ(displayValue(1.0, filmic), 2.54 / 3.16);
    EXPECT_EQ(displayValue(100.0, filmic), 1.0);
}

TEST(Oracle_Display, NoRadianceIsBeyondIt)
{
    for (const ToneCurve curve : {ToneCurve::none, ToneCurve::reinhard, ToneCurve::filmic}) {
        const Display display{.exposure = 3.0, .curve = curve, .gamma = {}};
        EXPECT_DOUBLE_EQ(displayValue(std::numeric_limits<double>::infinity(), display), 1.0);
        EXPECT_DOUBLE_EQ(displayValue(1e30, display), 1.0);
        EXPECT_EQ(displayValue(-1.0, display), 0.0);
        EXPECT_EQ(displayValue(-std::numeric_limits<double>::infinity(), display), 0.0);
        EXPECT_EQ(displayValue(std::numeric_limits<double>::quiet_NaN(), display), 0.0);
    }
}

} // namespace dioptre
