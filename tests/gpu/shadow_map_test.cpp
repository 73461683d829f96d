// Shadow maps against the tracer's shadows.
#include "support/compare.h"
#include "support/rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

const std::string head = "[camera]\neye = [0, 3, 5]\ntarget = [0, 0.5, 0]\nfov_y_deg = 40\n";
const std::string things =
    "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n"
    "[[rectangle]]\ncorner = [-1.5, 0.3, -0.5]\nedge_u = [1, 0, 0.3]\nedge_v = [0.1, 1.2, 0]\n"
    "[[triangle]]\na = [0.2, 1, 0]\nb = [1.2, 1.1, -0.2]\nc = [0.7, 1.4, 0.8]\n";
const std::string balls =
    "[[sphere]]\ncentre = [1.3, 0.5, 0.6]\nradius = 0.5\n"
    "[[cylinder]]\nbase = [-0.6, 0, 0.9]\naxis = [0, 0.7, 0]\nradius = 0.3\ncapped = true\n";

const std::vector<std::pair<const char*, std::string>>& lights()
{
    static const std::vector<std::pair<const char*, std::string>> all = {
        {"directional", "[[light]]\nkind = \"directional\"\ndirection = [0.6, -1, -0.4]\n"},
        {"point", "[[light]]\nkind = \"point\"\nposition = [-1.5, 3, 1.5]\n"},
        {"narrow spot", "[[light]]\nkind = \"spot\"\nposition = [-1.5, 4, 2]\ndirection = [0.4, -1, "
                        "-0.5]\ncutoff_deg = 35\n"},
        {"wide spot", "[[light]]\nkind = \"spot\"\nposition = [-1, 2.5, 1]\ndirection = [0.4, -1, "
                      "-0.5]\ncutoff_deg = 85\n"},
        {"glowing sphere",
         "[material.lamp]\nemission = [200, 200, 200]\nlight = true\n[[sphere]]\ncentre = [0, "
         "2.5, 1]\nradius = 0.2\nmaterial = \"lamp\"\n"}};
    return all;
}

Picture by(const std::string& method, const std::string& toml, const std::vector<std::string>& overrides = {})
{
    return renderSceneText(toml, {200, 150, 1, overrides, "auto", 0.0, DataView::none, method}).picture;
}

// Pixels that are off by more than a tenth: lit in one picture and dark in the other.
std::size_t wrong(const Picture& a, const Picture& b)
{
    return compare(a, b, 0.1).over;
}

} // namespace

// Only a texel's width along a shadow's edge is wrong: half as many pixels with twice the texels.
TEST(ShadowMap, ShowsTheTracersShadows_AndTheFinerTheNearer)
{
    for (const auto& [name, light] : lights()) {
        const std::string scene = head + light + things;
        const Picture traced = by("trace", scene);
        const Picture unshaded = by("phong:16", scene, {"raster.shadow_map=0"});
        const auto without = wrong(unshaded, traced);
        const auto coarse = wrong(by("phong:16", scene, {"raster.shadow_map=256"}), traced);
        const auto fine = wrong(by("phong:16", scene, {"raster.shadow_map=2048"}), traced);
        std::cout << name << ": wrong pixels " << without << " without, " << coarse << " at 256, " << fine
                  << " at 2048\n";
        EXPECT_GT(without, 400U) << name << ": there is a shadow to be seen";
        EXPECT_LT(coarse, without / 4) << name;
        EXPECT_LT(fine, coarse / 2) << name;
        EXPECT_LT(fine, 40U) << name;
    }
}

// A flat shape that nothing lies behind is left out of the maps: this is there to be shaded, out of sight.
const std::string under = "[[sphere]]\ncentre = [0, -3, 0]\nradius = 0.2\n";

// Every pixel that the tracer lights and no shadow's edge is near must be lit: on slopes at any angle to the
// light.
TEST(ShadowMap, SurfacesDoNotShadowThemselves_AtAnyAngleToTheLight)
{
    for (const double angle_deg : {0.0, 30.0, 60.0, 80.0, 88.0}) {
        const double a = angle_deg * 3.14159265358979 / 180.0;
        for (const bool point : {false, true}) {
            const std::string light =
                point ? fmt::format("[[light]]\nkind = \"point\"\nposition = [{}, {}, 0]\n",
                                    9.0 * std::sin(a), 9.0 * std::cos(a))
                      : fmt::format("[[light]]\nkind = \"directional\"\ndirection = [{}, {}, 0]\n",
                                    -std::sin(a), -std::cos(a));
            const std::string scene =
                head + light + "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = 2\n" + under;
            const Picture traced = by("trace", scene);
            for (const char* filter : {"nearest", "pcf"}) {
                const Picture drawn =
                    by("phong:64", scene,
                       {"raster.shadow_map=256", std::string("raster.shadow_filter=") + filter});
                // The rim of 64 facets lies beside the disk's own.
                EXPECT_LT(wrong(drawn, traced), 30U)
                    << angle_deg << " degrees, " << (point ? "point, " : "directional, ") << filter;
            }
            if (angle_deg == 60.0) {
                EXPECT_GT(
                    wrong(by("phong:64", scene, {"raster.shadow_map=256", "raster.shadow_bias=0"}), traced),
                    1000U)
                    << "the bias is what it takes";
            }
        }
    }
}

// No map holds a plane: a sun behind a wall, above a ceiling, below the ground.
TEST(ShadowMap, EndlessPlanesShadeAllThatIsBehindThem)
{
    const std::string scene = "[camera]\neye = [0, 3, 9]\ntarget = [0, 1, 0]\n[[light]]\nkind = \"ambient\"\n"
                              "ambient = [0.1, 0.1, 0.1]\n[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n"
                              "[[plane]]\npoint = [0, 0, -5]\nnormal = [0, 0, 1]\n"
                              "[[sphere]]\ncentre = [0, 0.7, 0]\nradius = 0.5\n[[light]]\n";
    for (const char* light :
         {"kind = \"directional\"\ndirection = [0, -0.3, 1]\n",
          "kind = \"directional\"\ndirection = [0.2, 1, -0.1]\n",
          "kind = \"directional\"\ndirection = [0.2, -1, -0.1]\n",
          "kind = \"point\"\nposition = [1, 2, -7]\n", "kind = \"point\"\nposition = [1, 2, 2]\n"})
        for (const std::string method : {"phong:64", "gouraud:64"}) {
            // A lamp's light is not to be mixed over facets of six metres.
            if (method == "gouraud:64" && std::string(light).find("point") != std::string::npos)
                continue;
            EXPECT_LT(wrong(by(method, scene + light,
                               {"plane.0.raster_extent_m=400", "plane.1.raster_extent_m=400"}),
                            by("trace", scene + light)),
                      150U)
                << method << ": " << light;
        }
}

// A ground of a kilometre under a ball of a metre: the map is the ball's alone.
TEST(ShadowMap, AGroundThatShadesNothing_TakesNoPartOfTheMap)
{
    const std::string scene =
        head + lights()[0].second +
        "[[rectangle]]\ncorner = [-500, 0, 500]\nedge_u = [1000, 0, 0]\nedge_v = [0, 0, -1000]\n" +
        "[[sphere]]\ncentre = [0, 0.5, 0]\nradius = 0.5\n";
    EXPECT_LT(wrong(by("phong:64", scene), by("trace", scene)), 40U);
}

// The light's maps are six from the start where its cone is animated.
TEST(ShadowMap, AConeThatOpensWideKeepsItsShadows)
{
    const auto path = std::filesystem::temp_directory_path() / "dioptre-opening-cone.toml";
    std::ofstream(path)
        << head +
               "[[light]]\nkind = \"spot\"\nposition = [-1, 3, 1]\ndirection = [0.3, -1, -0.4]\ncutoff_deg = "
               "30\n" +
               things + "[[animate]]\npath = \"light.0.cutoff_deg\"\ntimes = [0, 1]\nvalues = [30, 85]\n";
    const Request request{120, 90, 1, {}, "auto", 0.0, DataView::none, "phong:16"};
    const auto pictures = rasteriseMoments(path, request, {0.0, 1.0});
    for (const double time_s : {0.0, 1.0})
        EXPECT_LT(wrong(pictures[time_s > 0.0 ? 1 : 0].picture,
                        test::renderScene(path, {120, 90, 1, {}, "auto", time_s}).picture),
                  40U)
            << time_s << " s";
    std::filesystem::remove(path);
}

TEST(ShadowMap, RoundShapesThrowShadows_AndTakeThem)
{
    for (const auto& [name, light] : lights()) {
        const std::string scene = head + light + things + balls;
        const auto difference = wrong(by("phong:128", scene, {"raster.shadow_map=2048"}), by("trace", scene));
        std::cout << name << ": " << difference << " wrong pixels\n";
        EXPECT_LT(difference, 100U) << name << " of 30000";
    }
}

// A map that is wide one way and narrow the other: its texels are long, and so is what each stands for.
TEST(ShadowMap, TexelsMayBeLong)
{
    const std::string scene =
        head + "[[light]]\nkind = \"directional\"\ndirection = [-0.6, -0.8, 0.02]\n" +
        "[[rectangle]]\ncorner = [-1.5, 0, 1]\nedge_u = [0, 0, -2.5]\nedge_v = [0, 2, 0]\n" +
        "[[rectangle]]\ncorner = [-40, -2, 0.5]\nedge_u = [0, 0, -0.4]\nedge_v = [60, 0, 0]\n";
    EXPECT_LT(wrong(by("phong:64", scene, {"raster.shadow_map=512"}), by("trace", scene)), 100U);
}

// The middle of a filtered edge is neither lit nor dark.
TEST(ShadowMap, TheFilterSoftensEdges)
{
    const std::string scene = head + lights()[0].second + things;
    const auto between = [&](const std::string& filter) {
        const Picture lit = by("phong:8", scene, {"raster.shadow_map=0"});
        const Picture shaded =
            by("phong:8", scene, {"raster.shadow_map=256", "raster.shadow_filter=" + filter});
        std::size_t count = 0;
        for (std::size_t i = 0; i < lit.floats.size(); i += 4) {
            const float share = lit.floats[i] > 0.0F ? shaded.floats[i] / lit.floats[i] : 0.0F;
            count += share > 0.05F && share < 0.95F ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(between("nearest"), 0U);
    EXPECT_GT(between("pcf"), 60U);
}

// Defect 48: a map that is drawn once shows where things were. One renderer goes through all moments; each of
// its pictures is that of a renderer made for that moment.
TEST(ShadowMap, IsDrawnAnewWhenThingsMove)
{
    const auto orrery = glslFolder() / "scenes" / "orrery.toml";
    const Request request{120, 90, 1, ownPictures(orrery), "auto", 0.0, DataView::none, "phong:16"};
    const std::vector<double> moments = {0.0, 1.5, 4.0, 0.0};
    const auto pictures = rasteriseMoments(orrery, request, moments);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        Request fresh = request;
        fresh.time_s = moments[i];
        EXPECT_EQ(test::renderScene(orrery, fresh).picture.floats, pictures[i].picture.floats)
            << moments[i] << " s";
    }
    EXPECT_GT(wrong(pictures[0].picture, pictures[1].picture), 50U) << "or nothing moves";
}

// An eye that moves moves no shadow: its frames do not pay for maps.
TEST(ShadowMap, StaysWhileTheEyeAloneMoves)
{
    const auto path = std::filesystem::temp_directory_path() / "dioptre-moving-eye.toml";
    std::ofstream(path) << head + lights()[1].second + things +
                               "[[animate]]\npath = \"camera.eye\"\ntimes = [0, 1]\n"
                               "values = [[0, 3, 5], [2, 3, 5]]\n";
    const Request request{40, 30, 1, {}, "auto", 0.0, DataView::none, "phong:16"};
    const auto pictures = rasteriseMoments(path, request, {0.0, 0.5, 1.0});
    EXPECT_EQ(pictures.back().raster->shadowMapDraws, 1);
    EXPECT_NE(pictures.back().picture.floats, pictures.front().picture.floats);
    const auto orrery = glslFolder() / "scenes" / "orrery.toml";
    Request moving = request;
    moving.overrides = ownPictures(orrery);
    EXPECT_EQ(rasteriseMoments(orrery, moving, {0.0, 0.5, 1.0}).back().raster->shadowMapDraws, 3);
    std::filesystem::remove(path);
}

TEST(ShadowMap, BackendsAgree)
{
    const std::string scene = head + lights()[1].second + things + balls;
    const Request egl{120, 90, 2, {}, "egl", 0.0, DataView::none, "phong:32"};
    Request osmesa = egl;
    osmesa.backend = "osmesa";
    const auto difference =
        compareEncoded(renderSceneText(scene, egl).picture, renderSceneText(scene, osmesa).picture, 1.0);
    EXPECT_LE(difference.over, difference.pixels / 500);
}
