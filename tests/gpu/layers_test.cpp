// Layers beside the colours: hand-derived numbers, and the views that they are drawn by.
#include "render/layers.h"
#include "scene/load.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// The view is 90 degrees: pixel x of 33 looks along ((2 x + 1) / 33 - 1, ..., -1).
const std::string scene = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 90\n"
                          "[[disk]]\ncentre = [0, -4, 0]\nnormal = [0, 1, 0]\nradius = 2\n"
                          "[[sphere]]\nname = \"ball\"\ncentre = [0, 0, 0]\nradius = 1\n";
constexpr int side = 33;

std::vector<ExrLayer> layersOf(const std::string& toml, const std::vector<std::string>& names, int samples)
{
    const ViewSettings view{side, side, samples, glslFolder()};
    return LayerDrawer(parseScene(toml, "text.toml"), layersNamed(names), view, contextFor("auto"))
        .draw({0, 0, side, side});
}

// In the middle of the picture, or `right` and `up` of it.
float at(const ExrLayer& layer, int right, int up)
{
    return layer.numbers.at(static_cast<std::size_t>((side / 2 + up) * side + side / 2 + right));
}

} // namespace

TEST(Layers, OnABallADiskAndNothing_AreWhatGeometrySays)
{
    const auto layers = layersOf(scene, {"object", "depth", "normal"}, 1);
    std::vector<std::string> channels;
    for (const auto& layer : layers)
        channels.push_back(layer.channel);
    ASSERT_EQ(channels,
              (std::vector<std::string>{"depth.Z", "normal.X", "normal.Y", "normal.Z", "object.id"}));
    // The ball's front, 4 m ahead, faces the eye.
    EXPECT_NEAR(at(layers[0], 0, 0), 4.0F, 1e-5F);
    EXPECT_NEAR(at(layers[1], 0, 0), 0.0F, 1e-5F);
    EXPECT_NEAR(at(layers[3], 0, 0), 1.0F, 1e-5F);
    EXPECT_EQ(at(layers[4], 0, 0), 1.0F);
    // 13 rows down the ray falls 26/33 m for each metre ahead, and 4 m after 66/13 m: within the disk.
    const float ahead = 66.0F / 13.0F;
    EXPECT_NEAR(at(layers[0], 0, -13), std::hypot(ahead, 4.0F), 1e-5F);
    EXPECT_NEAR(at(layers[2], 0, -13), 1.0F, 1e-5F);
    EXPECT_EQ(at(layers[4], 0, -13), 0.0F);
    // Above there is nothing.
    const std::vector<float> nothing = {0.0F, 0.0F, 0.0F, 0.0F, -1.0F};
    for (std::size_t i = 0; i < layers.size(); ++i)
        EXPECT_EQ(at(layers[i], 0, 16), nothing[i]) << layers[i].channel;
}

TEST(Layers, OfManySamples_AreMeansOfWhatIsMet_ButForObjects)
{
    const auto one = layersOf(scene, {"object", "normal"}, 1);
    const auto many = layersOf(scene, {"depth", "normal", "object"}, 16);
    ASSERT_EQ(many.size(), 5U);
    EXPECT_EQ(many[4].numbers, one[3].numbers) << "the centre's sample alone";
    const auto depth = renderSceneText(scene, {side, side, 16, {}, "auto", 0.0, DataView::depth}).picture;
    std::size_t edges = 0;
    for (std::size_t i = 0; i < many[0].numbers.size(); ++i) {
        EXPECT_NEAR(many[0].numbers[i], depth.floats[4 * i], 1e-5F) << "as --view depth";
        const float length = std::hypot(many[1].numbers[i], many[2].numbers[i], many[3].numbers[i]);
        EXPECT_LT(length, 1.0001F);
        // A pixel that any sample meets has nearly a whole normal, however few they are.
        EXPECT_EQ(length > 0.5F, many[0].numbers[i] > 0.0F) << length;
        edges += (many[0].numbers[i] > 0.0F) != (many[4].numbers[i] >= 0.0F) ? 1 : 0;
    }
    EXPECT_GT(edges, 0U) << "pixels whose centre misses what other samples meet";
}

// The object view has one colour for objects 77 and 221; numbers do not come again.
TEST(Layers, ObjectsOfOneColour_HaveTheirOwnNumbers)
{
    ASSERT_EQ(objectColour(77), objectColour(221));
    constexpr int count = 10 * side;
    std::string many = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 90\n"
                       "[trace]\nform = \"loop\"\n";
    for (int i = 0; i < count; ++i) // one for each pixel of the lowest rows
        many += "[[sphere]]\ncentre = [" + std::to_string(10.0 * (i % side - side / 2) / side) + ", " +
                std::to_string(10.0 * (i / side - side / 2) / side) + ", 0]\nradius = 0.1\n";
    const auto layers = layersOf(many, {"object"}, 1);
    for (int i = 0; i < side * side; ++i)
        EXPECT_EQ(layers[0].numbers[static_cast<std::size_t>(i)], i < count ? static_cast<float>(i) : -1.0F);
}

TEST(Layers, OfAnEmptyScene_AreThoseOfNothing)
{
    const auto layers = layersOf("[sky]\ncolour = [1, 1, 1]\n", {"depth", "normal", "object"}, 2);
    for (const auto& layer : layers)
        EXPECT_EQ(std::ranges::count(layer.numbers, layer.channel == "object.id" ? -1.0F : 0.0F), side * side)
            << layer.channel;
}
