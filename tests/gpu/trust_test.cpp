// How far single precision can be trusted: the device's account against the one in double precision, and both
// against what single precision really gets wrong.
#include "kernel/trust.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

struct Account {
    double beyond = 0.0; // share of the samples
    double bits = 0.0;   // lost, mean
};

Account meanOf(const Picture& account)
{
    Account mean;
    for (std::size_t i = 0; i < account.floats.size(); i += 4) {
        mean.beyond += static_cast<double>(account.floats[i]);
        mean.bits += static_cast<double>(account.floats[i + 1]);
    }
    const double pixels = static_cast<double>(account.floats.size()) / 4.0;
    return {mean.beyond / pixels, mean.bits / pixels};
}

Picture onDevice(const std::string& toml, int width, int height)
{
    return renderSceneText(toml, {width, height, 1, {}, "auto", 0.0, DataView::trust}).picture;
}

Picture inDouble(const std::string& toml, int width, int height)
{
    const Scene scene = parseScene(toml, glslFolder() / "scenes" / "text.toml", {}, 0.0, places());
    const ViewSettings view{width, height, 1, glslFolder()};
    return accountOfTrust(prepare(scene, view).packed, width, height, 1, {0, 0, width, height});
}

// A plane that wears squares of a size, seen from 10 m.
std::string squares(const std::string& size)
{
    return "[camera]\neye = [0, 10, 0]\ntarget = [0, 0, 0.1]\n[[light]]\nkind = \"ambient\"\nambient = [1, "
           "1, 1]\n"
           "[material.m]\npattern = \"checker\"\ncolours = [[1, 1, 1], [0, 0, 0]]\nsize = " +
           size + "\n[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n";
}

// Four mirrors in a tetrahedron, 2.02 radii apart, looked at through a gap, under a pictured sky.
const std::string cage = R"(
[camera]
eye = [2.7, 2.7, -2.7]
target = [0.0, 0.0, 0.0]
fov_y_deg = 7.0
[sky]
image = "sky.exr"
[trace]
budget = 64
cut_off = 0.0
[material.mirror]
colour = [0.0, 0.0, 0.0]
mirror = 1.0
[[sphere]]
centre = [0.7142, 0.7142, 0.7142]
radius = 1.0
material = "mirror"
[[sphere]]
centre = [0.7142, -0.7142, -0.7142]
radius = 1.0
material = "mirror"
[[sphere]]
centre = [-0.7142, 0.7142, -0.7142]
radius = 1.0
material = "mirror"
[[sphere]]
centre = [-0.7142, -0.7142, 0.7142]
radius = 1.0
material = "mirror"
)";

} // namespace

TEST(Trust, OfScenesOfOrdinaryNumbers_IsHardlyEverLost)
{
    for (const char* name : {"still_life", "glass", "crowd", "prism", "textures"}) {
        const auto scene = glslFolder() / "scenes" / (std::string(name) + ".toml");
        const auto account = meanOf(
            test::renderScene(scene, {160, 90, 1, ownPictures(scene), "auto", 0.0, DataView::trust}).picture);
        std::cout << name << ": " << 100.0 * account.beyond << " % beyond, " << account.bits
                  << " bits lost\n";
        EXPECT_LT(account.beyond, 0.01) << name;
        EXPECT_GT(account.bits, 0.5) << name << ": some rounding there is";
    }
}

TEST(Trust, OnTheDevice_IsWhatDoublePrecisionReckons)
{
    for (const char* name : {"still_life", "glass", "mirrors", "orrery", "planet", "whispering"}) {
        const auto file = glslFolder() / "scenes" / (std::string(name) + ".toml");
        const Scene scene = loadScene(file, ownPictures(file), 0.0, places());
        const ViewSettings view{160, 90, 1, glslFolder()};
        const auto twice = meanOf(accountOfTrust(prepare(scene, view).packed, 160, 90, 1, {0, 0, 160, 90}));
        const auto device = meanOf(
            test::renderScene(file, {160, 90, 1, ownPictures(file), "auto", 0.0, DataView::trust}).picture);
        EXPECT_NEAR(device.beyond, twice.beyond, 0.002) << name;
        EXPECT_NEAR(device.bits, twice.bits, 0.02 * twice.bits) << name;
    }
}

TEST(Trust, InAPattern_EndsWhereItsSquaresAreAsFineAsTheRounding)
{
    // 10 m of way lose 2^-24 of themselves to the direction and again to the crossing: 1.2e-6 m, a tenth of a
    // square of 1.2e-5 m.
    EXPECT_EQ(meanOf(onDevice(squares("1.0"), 32, 18)).beyond, 0.0);
    EXPECT_EQ(meanOf(onDevice(squares("3e-5"), 32, 18)).beyond, 0.0);
    EXPECT_EQ(meanOf(onDevice(squares("1e-5"), 32, 18)).beyond, 1.0);
}

// A kernel of its own keeps the place, and not the pattern, which is laid out from a point 1e7 m away: 0.6 m
// is lost of it.
TEST(Trust, InAPatternFromAFarAnchor_IsLost_WhateverTheKernel)
{
    const auto far = [](const std::string& size) {
        return "[camera]\neye = [0, 2, 0]\ntarget = [0, 0, 0.1]\n[[light]]\nkind = \"ambient\"\nambient = "
               "[1, 1, 1]\n"
               "[material.m]\npattern = \"checker\"\ncolours = [[1, 1, 1], [0, 0, 0]]\nsize = " +
               size + "\n[[plane]]\npoint = [1e7, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n";
    };
    EXPECT_TRUE(makePlan(parseScene(far("1"), "text.toml")).choosesKernels());
    EXPECT_EQ(meanOf(onDevice(far("1"), 32, 18)).beyond, 1.0);
    EXPECT_EQ(meanOf(inDouble(far("1"), 32, 18)).beyond, 1.0);
    EXPECT_EQ(meanOf(onDevice(far("100"), 32, 18)).beyond, 0.0);
}

TEST(Trust, OnAnEndlessPlainPlane_IsNeverLost)
{
    const std::string plain = "[camera]\neye = [0, 1e-3, 0]\ntarget = [0, 0, -1]\n"
                              "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n";
    EXPECT_EQ(meanOf(onDevice(plain, 32, 18)).beyond, 0.0);
}

TEST(Trust, AmongChaoticMirrors_IsLostWhereSinglePrecisionReallyErrs)
{
    const Request request{256, 144, 1, {}, "auto"};
    const Picture single = renderSceneText(cage, request).picture;
    const Picture twice = renderDoubleText(cage, request);
    const Picture account = onDevice(cage, 256, 144);
    const Picture reckoned = inDouble(cage, 256, 144);
    double wrong = 0.0, told = 0.0, beyond = 0.0, unlike = 0.0;
    for (std::size_t i = 0; i < single.floats.size(); i += 4) {
        double off = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            off = std::max(off, std::abs(static_cast<double>(single.floats[i + c]) -
                                         static_cast<double>(twice.floats[i + c])));
        const bool flagged = account.floats[i] > 0.5F;
        beyond += flagged ? 1.0 : 0.0;
        unlike += flagged && off > 0.01 ? 1.0 : 0.0;
        wrong += off > 0.3 ? 1.0 : 0.0;
        told += flagged && off > 0.3 ? 1.0 : 0.0;
    }
    const double pixels = static_cast<double>(single.floats.size()) / 4.0;
    std::cout << "wrong " << 100.0 * wrong / pixels << " %, of which told " << 100.0 * told / wrong
              << " %; beyond trust " << 100.0 * beyond / pixels << " %, of which off by over 0.01 "
              << 100.0 * unlike / beyond << " %; in double " << 100.0 * meanOf(reckoned).beyond << " %\n";
    ASSERT_GT(wrong, 50.0);
    EXPECT_GT(told, 0.95 * wrong);
    // The sky is much alike in most directions, and rounding is rarely as bad as it may be.
    EXPECT_GT(unlike, 0.3 * beyond);
    EXPECT_LT(beyond, 0.05 * pixels);
    EXPECT_NEAR(meanOf(reckoned).beyond, beyond / pixels, 0.01);
}
