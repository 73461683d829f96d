// What views leave out of the shader, their colours and their legends.
#include "render/assemble.h"
#include "render/view_picture.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace dioptre;

namespace
{

PreparedScene preparedFor(DataView view, const std::string& more = "")
{
    const std::filesystem::path glsl = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";
    const std::string scene =
        "[camera]\neye = [0, 0, 5]\n[sky]\nimage = \"sky.exr\"\n"
        "[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n"
        "[material.m]\nimage = \"planet.png\"\nmirror = 0.5\n"
        "[[sphere]]\nname = \"ball\"\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n" +
        more;
    return prepare(parseScene(scene, glsl / "scenes" / "text.toml", {}, 0.0, {{}, glsl}),
                   {32, 18, 1, glsl, {}, view});
}

std::string textOf(const PreparedScene& prepared)
{
    return flatten(assemble(prepared.scene, prepared.plan, prepared.packed,
                            std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl"));
}

// One row of grey pixels.
Picture data(const std::vector<float>& grey)
{
    Picture picture{static_cast<int>(grey.size()), 1, PixelFormat::float32, {}, {}};
    for (const float value : grey)
        picture.floats.insert(picture.floats.end(), {value, value, value, 1.0F});
    return picture;
}

double figure(const ViewLegend& legend, const std::string& name)
{
    for (const auto& [key, value] : legend.figures)
        if (key == name)
            return value;
    throw std::logic_error("no figure " + name);
}

const std::vector<std::pair<DataView, std::vector<std::string>>> tokens = {
    {DataView::rays, {"lostAtOnce", "weightOfWaiting"}},
    {DataView::lost, {"lostAtOnce", "weightOfWaiting"}},
    {DataView::object, {"firstHit", "objectColour"}},
    {DataView::normal, {"firstHit", "0.5 + 0.5 *"}},
    {DataView::depth, {"firstHit", "vec3(hit.t"}},
    {DataView::uv, {"firstHit", "coordinates.picture"}},
    {DataView::trust, {"trustAt", "crossingRounding", "blurOf"}}};

} // namespace

TEST(View, ItsCodeIsThereWithIt_AndNothingOfItWithout)
{
    const auto light = preparedFor(DataView::none);
    const auto text = textOf(light);
    EXPECT_FALSE(light.plan.has("view"));
    for (const auto& [view, expected] : tokens) {
        const auto prepared = preparedFor(view);
        EXPECT_TRUE(prepared.plan.has("view"));
        for (const auto& token : expected) {
            EXPECT_NE(textOf(prepared).find(token), std::string::npos) << token << " in " << rowOf(view).name;
            if (token != "coordinates.picture") { // this scene's picture has some too
                EXPECT_EQ(text.find(token), std::string::npos) << token;
            }
        }
    }
}

TEST(View, OfTheFirstHit_LeavesOutLightsTreeSkyAndPictures)
{
    for (const auto view : {DataView::object, DataView::normal, DataView::depth, DataView::uv}) {
        const auto prepared = preparedFor(view);
        const auto text = textOf(prepared);
        for (const char* token : {"u_lights", "u_pictures", "u_sky", "u_budget", "scatter", "lightThrough"})
            EXPECT_EQ(text.find(token), std::string::npos) << token << " in " << rowOf(view).name;
        EXPECT_TRUE(prepared.packed.pictures.empty());
        EXPECT_TRUE(prepared.packed.sky_picture.empty());
        EXPECT_EQ(prepared.plan.feature("mirror").reason, "the view asks for none");
    }
}

TEST(View, OfTheTree_CutsWhereThePictureDoes)
{
    const auto light = preparedFor(DataView::none);
    const auto lost = preparedFor(DataView::lost);
    EXPECT_TRUE(lost.packed.sky_picture.empty());
    EXPECT_LT(light.packed.cutOff, light.scene.trace.cutOff) << "the sky is brighter than 1";
    EXPECT_EQ(lost.packed.cutOff, light.packed.cutOff);
}

TEST(ObjectColours, AreDistinctAndNeverBlack)
{
    std::set<std::array<int, 3>> seen;
    for (std::size_t object = 0; object < 200; ++object) {
        const auto colour = objectColour(object);
        EXPECT_TRUE(seen.insert(colour).second) << object;
        EXPECT_GE(*std::ranges::max_element(colour), 128) << object;
    }
    // Those of a small scene are far apart: 24 steps of 255 in some channel.
    for (std::size_t a = 0; a < 16; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(objectColour(a)[c] - objectColour(b)[c]));
            EXPECT_GE(most, 24) << a << " and " << b;
        }
}

TEST(Legend, OfObjects_ListsColourNumberNameAndKind)
{
    const auto prepared =
        preparedFor(DataView::object, "[[disk]]\ncentre = [3, 0, 0]\nnormal = [0, 0, 1]\nradius = 1\n");
    const auto legend = shownView(data({0.0F}), prepared).legend;
    ASSERT_EQ(legend.objects.size(), 2U);
    const auto [red, green, blue] = objectColour(1);
    EXPECT_EQ(legend.objects[0].name, "ball");
    EXPECT_EQ(legend.objects[0].kind, "sphere");
    EXPECT_EQ(legend.objects[1].colour, fmt::format("#{:02x}{:02x}{:02x}", red, green, blue));
    EXPECT_EQ(legend.lines.back(), legend.objects[1].colour + "    1  disk");
}

TEST(Legend, OfRays_StandsForTheBudgetsFactors)
{
    // Budget 16: the five colours are 1, 2, 4, 8, 16 rays.
    const auto [picture, legend] = shownView(data({1.0F, 2.0F, 16.0F, 1.0F}), preparedFor(DataView::rays));
    EXPECT_EQ(figure(legend, "mean"), 5.0);
    EXPECT_EQ(figure(legend, "max"), 16.0);
    ASSERT_EQ(legend.lines.size(), 6U);
    for (const auto& [line, pixel, rays] :
         {std::tuple{1, 0, "  1"}, std::tuple{2, 1, "  2"}, std::tuple{5, 2, "  16"}}) {
        const auto byte = [&, at = pixel](int c) {
            return static_cast<int>(
                std::lround(255.0F * picture.floats[static_cast<std::size_t>(4 * at + c)]));
        };
        EXPECT_EQ(legend.lines[static_cast<std::size_t>(line)],
                  fmt::format("#{:02x}{:02x}{:02x}{}", byte(0), byte(1), byte(2), rays));
    }
}

TEST(Legend, OfLostWeight_TellsEachCausesMean)
{
    Picture lost{2, 1, PixelFormat::float32, {}, {0.5F, 0.0F, 0.01F, 1.0F, 0.1F, 0.2F, 0.0F, 1.0F}};
    const auto [picture, legend] = shownView(lost, preparedFor(DataView::lost));
    EXPECT_NEAR(figure(legend, "cut_off_percent"), 30.0, 1e-5);
    EXPECT_NEAR(figure(legend, "pool_percent"), 10.0, 1e-5);
    EXPECT_NEAR(figure(legend, "budget_percent"), 0.5, 1e-5);
    EXPECT_NEAR(figure(legend, "max_percent"), 50.0, 1e-5);
    EXPECT_NEAR(picture.floats[2], 0.6F, 1e-6F) << "1 % shows at 3/5";
    EXPECT_EQ(picture.floats[1], 0.0F);
}

TEST(Legend, OfDepth_NamesTheRange)
{
    const auto [picture, legend] = shownView(data({2.0F, 8.0F, 0.0F}), preparedFor(DataView::depth));
    EXPECT_EQ(figure(legend, "nearest_m"), 2.0);
    EXPECT_EQ(figure(legend, "farthest_m"), 8.0);
    EXPECT_EQ(legend.lines[1], "#ffffff  2 m");
    EXPECT_EQ(legend.lines[3], "#999999  3.2 m") << "halfway between 1/2 and 1/8";
    EXPECT_EQ(legend.lines[5], "#333333  8 m");
    EXPECT_NEAR(picture.floats[0], 1.0F, 1e-6F);
    EXPECT_NEAR(picture.floats[4], 0.2F, 1e-6F);
    EXPECT_EQ(picture.floats[8], 0.0F);
    EXPECT_EQ(shownView(data({0.0F}), preparedFor(DataView::depth)).legend.lines.size(), 2U);
}
