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

// Entries 0, 128 and 255 of 256 in matplotlib's _cm_listed.py.
TEST(Magma, EndsAndMiddle_AreMatplotlibs)
{
    const auto expectNear = [](const glm::dvec3& colour, const glm::dvec3& listed) {
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(colour[i], listed[i], 0.02);
    };
    expectNear(magma(0.0), {0.001462, 0.000466, 0.013866});
    expectNear(magma(128.0 / 255.0), {0.716387, 0.214982, 0.475290});
    expectNear(magma(1.0), {0.987053, 0.991438, 0.749504});
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
