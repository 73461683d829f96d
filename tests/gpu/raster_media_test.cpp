// What lies before the eye of the rasterised methods: glass, water, and depth without end.
#include "support/compare.h"
#include "support/rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

Rendered by(const std::string& method, const std::string& toml, int samples)
{
    return renderSceneText(toml, {192, 144, samples, {}, "auto", 0.0, DataView::none, method});
}

} // namespace

// Straight through both caps of a glass cylinder, as through a slab; the tracer loses 8 % to reflections.
TEST(RasterisedMedia, AGlassCylindersCapsAreClear)
{
    const std::string scene =
        "[camera]\neye = [0.1, 0.2, 4]\ntarget = [0, 0, 0]\nfov_y_deg = 20\n[sky]\n"
        "gradient = [[0.1, 0.2, 0.1], [0.9, 0.8, 0.7], [0.2, 0.4, 0.9]]\n"
        "[material.m]\ntransmit = 1\nior = 1.5\n"
        "[[cylinder]]\nbase = [0, 0, -0.5]\naxis = [0, 0, 1]\nradius = 1\ncapped = true\nmaterial = \"m\"\n";
    const auto traced = by("trace", scene, 1).picture;
    const auto drawn = by("phong:64", scene, 1).picture;
    const std::size_t middle = 4 * (72 * 192 + 96);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(drawn.floats[middle + c], traced.floats[middle + c], 0.1F);
}

// Near and far, beads and planets: nothing vanishes and nothing shows through.
TEST(RasterisedMedia, DepthKeepsItsDigits_NearAndFar)
{
    const std::string light =
        "[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n[material.r]\ncolour = [1, 0, 0]\n"
        "[material.g]\ncolour = [0, 1, 0]\n[material.b]\ncolour = [0, 0, 1]\n";
    const auto ball = [](double x, double z, double radius, const char* material) {
        return fmt::format("[[sphere]]\ncentre = [{}, 0, {}]\nradius = {}\nmaterial = \"{}\"\n", x, z, radius,
                           material);
    };
    const std::string scenes[] = {"[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\n" + light +
                                      ball(0.2, -1.0, 0.1, "r") + ball(-3e7, -1e8, 2e7, "g"),
                                  "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\n" + light +
                                      ball(0.03, -0.1, 0.01, "r") + ball(0.0, -3000.0, 500.0, "g") +
                                      ball(100.0, -3020.0, 500.0, "b"),
                                  "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1e6]\n" + light +
                                      ball(0.2, -1.0, 0.3, "r") + ball(0.1, -0.5, 0.1, "g")};
    for (const auto& scene : scenes) {
        const auto difference = compare(by("phong:64", scene, 1).picture, by("trace", scene, 1).picture, 0.1);
        EXPECT_LT(difference.over, 90U) << scene; // along the outlines
    }
}

// Beer-Lambert on the way to an eye in water; the sky is infinitely far.
TEST(RasterisedMedia, AnEyeInAMediumLosesLightOnTheWay)
{
    const std::string scene =
        "[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\ninside = \"water\"\n[sky]\ncolour = [1, 1, 1]\n"
        "[material.water]\nabsorption = [0.1, 0.3, 0.6]\ntransmit = 1\nior = 1.33\n"
        "[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n" +
        std::string("[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    const auto drawn = by("phong:64", scene, 4).picture;
    EXPECT_LT(compare(drawn, by("trace", scene, 4).picture, 0.02).over, 200U) << "along the outline";
    EXPECT_EQ(drawn.floats[0] + drawn.floats[1] + drawn.floats[2], 0.0F);
}
