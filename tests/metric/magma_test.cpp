// The colour map against matplotlib's own entries.
#include "metric/magma.h"

#include <gtest/gtest.h>

using dioptre::magma;

namespace
{

double luminance(const glm::dvec3& encoded)
{
    return glm::dot(glm::pow(encoded, glm::dvec3(2.2)), glm::dvec3(0.2126, 0.7152, 0.0722));
}

} // namespace

// Every tenth part of matplotlib's 256 entries, from its _cm_listed.py.
TEST(Magma, Colours_AreMatplotlibsWithinTwoHundredths)
{
    struct Entry {
        int index;
        glm::dvec3 colour;
    };
    for (const auto& [index, colour] :
         {Entry{0, {0.001462, 0.000466, 0.013866}}, Entry{25, {0.078815, 0.054184, 0.211667}},
          Entry{51, {0.232077, 0.059889, 0.437695}}, Entry{76, {0.390384, 0.100379, 0.501864}},
          Entry{102, {0.550287, 0.161158, 0.505719}}, Entry{128, {0.716387, 0.214982, 0.475290}},
          Entry{153, {0.868793, 0.287728, 0.409303}}, Entry{179, {0.967671, 0.439703, 0.359810}},
          Entry{204, {0.994738, 0.624350, 0.427397}}, Entry{230, {0.995680, 0.812706, 0.572645}},
          Entry{255, {0.987053, 0.991438, 0.749504}}})
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(magma(index / 255.0)[channel], colour[channel], 0.02) << index << " " << channel;
}

TEST(Magma, LargerErrors_AreLighter)
{
    for (int i = 1; i <= 100; ++i)
        EXPECT_GT(luminance(magma(i / 100.0)), luminance(magma((i - 1) / 100.0))) << i;
}

TEST(Magma, WhatLiesOutside_IsClamped)
{
    EXPECT_EQ(magma(-1.0), magma(0.0));
    EXPECT_EQ(magma(7.0), magma(1.0));
}
