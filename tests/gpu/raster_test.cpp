// The rasterised methods beside the tracer: what they approach as facets get finer, what they cannot show,
// and that they draw every scene.
#include "raster/raster_renderer.h"
#include "render/still.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// One shape under every kind of light, without shadows, mirrors and glass.
std::string lit(const std::string& shape)
{
    return "[camera]\neye = [0, 1.2, 4]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n[sky]\ncolour = [0.2, 0.3, "
           "0.4]\n"
           "[material.m]\ncolour = [0.8, 0.4, 0.2]\nmodel = \"phong\"\nspecular = [0.5, 0.5, 0.5]\n"
           "shininess = 12\nshadow = \"none\"\n"
           "[[light]]\nkind = \"ambient\"\nambient = [0.1, 0.1, 0.1]\n"
           "[[light]]\nkind = \"point\"\nposition = [2, 3, 3]\ndiffuse = [0.5, 0.5, 0.5]\n"
           "[[light]]\nkind = \"directional\"\ndirection = [1, -1, -1]\ndiffuse = [0.3, 0.3, 0.3]\n" +
           shape + "material = \"m\"\n";
}

const std::string sphere = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
// Beyond the picture at both ends: no edge but its outline.
const std::string cylinder = "[[cylinder]]\nbase = [-0.8, -9, 0]\naxis = [1.6, 18, 0]\nradius = 0.7\n";
const std::string disk = "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0.3, 0.6, 1]\nradius = 1.1\n";

Rendered by(const std::string& method, const std::string& toml, int samples = 4,
            std::vector<std::string> overrides = {})
{
    return renderSceneText(toml,
                           {192, 144, samples, std::move(overrides), "auto", 0.0, DataView::none, method});
}

// RMSE over the pixels that both pictures cover whole with the shape: those at which neither shows any sky.
double rmseWithin(const Picture& a, const Picture& b, const Picture& coverage)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < a.floats.size(); i += 4)
        if (coverage.floats[i] == 0.0F)
            for (std::size_t c = 0; c < 3; ++c, count += 1.0)
                sum +=
                    std::pow(static_cast<double>(a.floats[i + c]) - static_cast<double>(b.floats[i + c]), 2);
    return std::sqrt(sum / count);
}

// Where the shape leaves a pixel or one beside it to the sky, 1; else 0. From a black shape before a white
// sky.
Picture coverageOf(const std::string& method, const std::string& shape)
{
    const Picture shown =
        by(method,
           "[camera]\neye = [0, 1.2, 4]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n[sky]\ncolour = [1, 1, 1]\n" +
               shape)
            .picture;
    Picture near = shown;
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x)
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    const int column = std::clamp(x + dx, 0, shown.width - 1);
                    const int row = std::clamp(y + dy, 0, shown.height - 1);
                    float& value = near.floats[static_cast<std::size_t>(4 * (y * shown.width + x))];
                    value = std::max(
                        value, shown.floats[static_cast<std::size_t>(4 * (row * shown.width + column))]);
                }
    return near;
}

} // namespace

// Phong's normals are off by the square of a facet's angle, and so is its light. Along the outline whole
// pixels are off, in a band as wide as that square: its RMSE falls with the root of the band, the first power
// of the angle. Measured: 1.2 to 1.4 for the whole picture, 2.0 within the outline of round shapes; a disk is
// exact there.
TEST(Rasterised, PhongConvergesToTheTracersPicture)
{
    for (const auto& [name, shape] : {std::pair("sphere", sphere), {"cylinder", cylinder}, {"disk", disk}}) {
        const Picture traced = by("trace", lit(shape)).picture;
        double first = 0.0, before = 0.0;
        double firstWithin = 0.0, beforeWithin = 0.0;
        for (const int n : {8, 16, 32, 64}) {
            const auto method = fmt::format("phong:{}", n);
            const Picture drawn = by(method, lit(shape)).picture;
            const double rmse = compare(drawn, traced, 0.01).rmse;
            const double within = rmseWithin(drawn, traced, coverageOf(method, shape));
            if (n == 8) {
                first = rmse;
                firstWithin = within;
            } else {
                // 3e-7: rounding, which is all that a disk has.
                EXPECT_LT(within, std::max(0.35 * beforeWithin, 3e-7))
                    << name << ": " << method << " against half as many";
            }
            before = rmse;
            beforeWithin = within;
        }
        EXPECT_GT(std::log2(first / before) / 3.0, 0.9) << name << ": order of the whole picture";
        if (firstWithin > 1e-6) {
            EXPECT_GT(std::log2(firstWithin / beforeWithin) / 3.0, 1.8)
                << name << ": order within the outline";
        }
        std::cout << name << ": orders " << std::log2(first / before) / 3.0 << " and "
                  << std::log2(firstWithin / beforeWithin) / 3.0 << " within the outline\n";
    }
}

namespace
{

float largestOf(const Picture& picture)
{
    float largest = 0.0F;
    for (std::size_t i = 0; i < picture.floats.size(); i += 4)
        largest = std::max(largest, picture.floats[i]);
    return largest;
}

// A black wall of 8 x 8 facets that the eye sees head-on, and a lamp at the eye, whose highlight lies `x`
// facets beside a corner of the net.
std::string highlightBeside(double x)
{
    return fmt::format(
        "[camera]\neye = [{0}, {0}, 3]\ntarget = [{0}, {0}, 0]\nfov_y_deg = 60\n"
        "[material.m]\ncolour = [0, 0, 0]\nmodel = \"phong\"\nspecular = [1, 1, 1]\nshininess = 400\n"
        "[[light]]\nkind = \"point\"\nposition = [{0}, {0}, 3]\n"
        "[[rectangle]]\ncorner = [-4, -4, 0]\nedge_u = [8, 0, 0]\nedge_v = [0, 8, 0]\nmaterial = \"m\"\n",
        x);
}

} // namespace

// M4. In the middle of a facet the highlight's peak, 1, is missed by all four corners, 0.71 m away: at that
// angle, 13 degrees, and its mirror's 26, cos^400 is 1e-19. Flat shading finds it there and spreads it over
// the facet.
TEST(Rasterised, AHighlightWithinAFacet_IsLostByGouraud_FoundByPhong_SpreadByFlat)
{
    const std::string scene = highlightBeside(0.5);
    const auto traced = by("trace", scene, 1).picture;
    EXPECT_GT(largestOf(traced), 0.95F) << "a pixel's middle lies beside the peak";
    EXPECT_LT(largestOf(by("gouraud:8", scene, 1).picture), 1e-6F);
    const auto phong = by("phong:8", scene, 1).picture;
    EXPECT_LT(compare(phong, traced, 0.01).largest, 1e-4);
    const auto flat = by("flat:8", scene, 1).picture;
    std::size_t bright = 0;
    for (std::size_t i = 0; i < flat.floats.size(); i += 4)
        bright += flat.floats[i] > 0.99F ? 1 : 0;
    // The facet, 1 m of the view's 3.46 m, is 41.6 pixels wide.
    EXPECT_NEAR(static_cast<double>(bright), 41.6 * 41.6, 90.0);
}

TEST(Rasterised, AHighlightAtACorner_IsFoundByGouraud_AndSpreadOverFourFacets)
{
    const std::string scene = highlightBeside(1.0);
    EXPECT_GT(largestOf(by("gouraud:8", scene, 1).picture), 0.9F);
    EXPECT_LT(largestOf(by("flat:8", scene, 1).picture), 1e-6F);
}

// Edges lie where the tracer's do, in every sample: an outline of straight edges is no difference of methods.
TEST(Rasterised, SamplesLieWhereTheTracersDo)
{
    const std::string scene =
        "[camera]\neye = [0, 0, 3]\ntarget = [0.1, 0.05, 0]\n[sky]\ncolour = [1, 1, 1]\n[[light]]\nkind = "
        "\"ambient\"\nambient = [0.25, 0.25, 0.25]\n"
        "[[triangle]]\na = [-0.9, -0.7, 0]\nb = [1.1, -0.2, 0.4]\nc = [-0.2, 0.9, -0.3]\n"
        "[[rectangle]]\ncorner = [0.3, 0.1, 0.2]\nedge_u = [0.5, 0.2, 0]\nedge_v = [-0.1, 0.4, 0.1]\n";
    const auto traced = by("trace", scene, 16).picture;
    for (const char* method : {"flat:8", "gouraud:8", "phong:8"}) {
        const auto difference = compare(by(method, scene, 16).picture, traced, 0.02);
        // OpenGL snaps corners to 1/256 of a pixel: single samples of edge pixels may fall to the other side,
        // 1/16 each.
        EXPECT_LE(difference.over, 12U) << method << " of " << difference.pixels;
        EXPECT_LT(difference.largest, 0.11) << method;
    }
}

TEST(Rasterised, OfTwoAtOneDepth_TheFirstStays)
{
    const std::string head =
        "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\n[[light]]\nkind = \"ambient\"\n"
        "ambient = [1, 1, 1]\n[material.red]\ncolour = [1, 0, 0]\n[material.green]\ncolour = [0, 1, 0]\n";
    const std::string wall =
        "[[rectangle]]\ncorner = [-5, -5, 0]\nedge_u = [10, 0, 0]\nedge_v = [0, 10, 0]\n";
    const std::string red = wall + "material = \"red\"\n";
    const std::string green = wall + "material = \"green\"\n";
    EXPECT_EQ(by("phong:8", head + red + green, 1).picture.floats[0], 1.0F);
    EXPECT_EQ(by("phong:8", head + green + red, 1).picture.floats[0], 0.0F);
}

// Mirrors and glass show the sky alone: where there is nothing else, that is what the tracer sees, too.
TEST(Rasterised, ALoneMirrorOrSlabOrBallOfGlass_IsAsTheTracerHasIt)
{
    const std::string head = "[camera]\neye = [0, 0.8, 4]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n[sky]\n"
                             "gradient = [[0.1, 0.2, 0.1], [0.9, 0.8, 0.7], [0.2, 0.4, 0.9]]\n";
    const std::string mirror = head + "[material.m]\nmirror = 0.9\nmirror_colour = [1, 0.9, 0.6]\n";
    const std::string glass = head + "[material.m]\ntransmit = 1\nior = 1.5\nabsorption = [0.3, 0.1, 0.2]\n";
    const auto off = [](const std::string& toml, const std::string& shape, const std::string& method,
                        std::vector<std::string> overrides = {}) {
        const auto scene = toml + shape + "material = \"m\"\n";
        return rmseWithin(by(method, scene, 4, overrides).picture, by("trace", scene, 4).picture,
                          coverageOf(method, shape));
    };
    EXPECT_LT(off(mirror, sphere, "phong:256"), 1e-3);
    EXPECT_LT(off(mirror, cylinder, "phong:256"), 1e-3);
    // The tracer also sees what is mirrored within the ball, 4 % and less.
    EXPECT_LT(off(glass, sphere, "phong:256"), 0.025);
    EXPECT_GT(off(glass, sphere, "phong:256", {"raster.interfaces=1"}), 0.1)
        << "half of the bending is left out";
}

namespace
{

// The tracer's text for a scene, whatever is said of rasterising.
std::string tracedText(const std::vector<std::string>& overrides)
{
    const auto scene = glslFolder() / "scenes" / "still_life.toml";
    return flatten(test::renderScene(scene, {16, 9, 1, overrides}).shader);
}

} // namespace

TEST(Rasterised, NothingOfItIsInATracedPicture)
{
    const auto scene = glslFolder() / "scenes" / "still_life.toml";
    const auto traced = test::renderScene(scene, {16, 9, 1, {}});
    EXPECT_FALSE(traced.raster);
    for (const auto* names : {&traced.uniforms, &traced.blocks, &traced.textures})
        for (const auto& name : *names)
            EXPECT_FALSE(name.find("hadow_map") != std::string::npos || name == "ShadowBlock" ||
                         name == "ObjectBlock" || name == "u_side")
                << name;
    EXPECT_EQ(flatten(traced.shader), tracedText({"raster.shadow_map=4096", "raster.shadow_filter=pcf",
                                                  "raster.interfaces=1", "raster.shadow_bias=3"}));
}

TEST(Rasterised, WhatTheSceneDoesNotNeed_IsNotThere)
{
    const auto plain = by("phong:8", lit(sphere)); // whose material casts no shadow
    EXPECT_EQ(plain.raster->shadowMaps, 0);
    EXPECT_EQ(flatten(plain.shader).find("seesLight"), std::string::npos);
    EXPECT_EQ(flatten(plain.shader).find("ShadowBlock"), std::string::npos);
    EXPECT_EQ(flatten(plain.shader).find("seenThrough"), std::string::npos);
    const auto shaded = by("phong:8", lit(sphere) + disk);
    EXPECT_EQ(shaded.raster->shadowMaps, 7) << "six of the point light, one of the directional";
    EXPECT_NE(flatten(shaded.shader).find("seesLight"), std::string::npos);
    EXPECT_EQ(by("phong:8", lit(sphere) + disk, 1, {"raster.shadow_map=0"}).raster->shadowMaps, 0);
}

// A tile is rounded as the whole picture is, bit for bit, also where the picture takes several cells.
TEST(Rasterised, APartOfThePicture_IsThatPartBitForBit)
{
    const auto scene = loadScene(glslFolder() / "scenes" / "still_life.toml", {}, 0.0, places());
    contextFor("auto");
    for (const auto& [width, height] : {std::pair(320, 256), {2240, 128}}) {
        ViewSettings view{width, height, 2, glslFolder()};
        const RasterScene raster = prepareRaster(scene, view, methodNamed("phong:16"));
        RasterRenderer renderer(raster, view);
        const Picture whole = drawStill(renderer, {0, 0, width, height}).picture;
        view.widthAtOnce = 192;
        view.heightAtOnce = 64;
        RasterRenderer inParts(raster, view);
        EXPECT_EQ(drawStill(inParts, {0, 0, width, height}).picture.floats, whole.floats) << width;
    }
}

TEST(Rasterised, BadLuckWithLights_IsToldWithTheMend)
{
    std::string scene = lit(sphere) + disk;
    for (int i = 0; i < 40; ++i)
        scene += fmt::format(
            "[[light]]\nkind = \"directional\"\ndirection = [{}, -1, 0]\ndiffuse = [0.01, 0.01, 0.01]\n", i);
    try {
        by("gouraud:8", scene, 1, {"raster.shadow_map=256"});
        ADD_FAILURE() << "more lights than a vertex can hand on";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("--method phong"), std::string::npos) << error.what();
    }
    EXPECT_EQ(by("phong:8", scene, 1, {"raster.shadow_map=256"}).counts.nonfinite, 0U);
    EXPECT_EQ(by("gouraud:8", scene, 1, {"raster.shadow_map=0"}).counts.nonfinite, 0U);
    try {
        by("phong:8", scene + std::string("[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n"), 1,
           {"raster.shadow_map=4096"});
        ADD_FAILURE() << "3 GiB of shadow maps";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("raster.shadow_map"), std::string::npos) << error.what();
    }
}
