// Parts of a picture that have programs of their own: no object is missed, and no pixel looks different.
#include "render/picture_parts.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/random_scene.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class PartsOfTheGallery : public testing::TestWithParam<std::filesystem::path>
{
};

INSTANTIATE_TEST_SUITE_P(Scenes, PartsOfTheGallery, testing::ValuesIn(galleryScenes()),
                         [](const auto& info) { return info.param.stem().string(); });

// The object whose colour in the object view a pixel has; none where nothing is met.
std::optional<std::size_t> objectAt(const Picture& view, std::size_t pixel, std::size_t objects)
{
    for (std::size_t id = 0; id < objects; ++id) {
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c)
            same = same && std::abs(view.floats[4 * pixel + c] -
                                    static_cast<float>(objectColour(id)[c]) / 255.0F) < 1e-3F;
        if (same)
            return id;
    }
    return std::nullopt;
}

// Objects that a pixel of the object view shows and its tile does not, as a count of pixels; `met` counts all
// pixels that show one.
std::size_t missed(const Scene& scene, const Picture& view, std::size_t& met)
{
    const auto tiles = seenInTiles(scene, view.width, view.height);
    const auto columns = static_cast<std::size_t>((view.width + 31) / 32);
    std::size_t count = 0;
    for (std::size_t pixel = 0; pixel < view.floats.size() / 4; ++pixel) {
        const auto object = objectAt(view, pixel, scene.objects.size());
        const auto width = static_cast<std::size_t>(view.width);
        const auto tile = pixel / width / 32 * columns + pixel % width / 32;
        met += object ? 1 : 0;
        count += object && !tiles.at(tile).at(*object) ? 1 : 0;
    }
    return count;
}

} // namespace

TEST_P(PartsOfTheGallery, EveryObjectThatAPixelShows_IsSeenInItsTile)
{
    Request request{200, 150, 1, {}, "auto"};
    request.view = DataView::object;
    const auto view = renderScene(GetParam(), request).picture;
    std::size_t met = 0;
    EXPECT_EQ(missed(loadScene(GetParam(), {}, 0.0, places()), view, met), 0U);
    EXPECT_GT(met, 1000U);
}

TEST_P(PartsOfTheGallery, EachByItsOwnProgram_DrawTheWholePicture)
{
    const auto drawn = [](const char* tiles) {
        return renderScene(GetParam(), {320, 180, 2, {std::string("plan.tiles=") + tiles}, "auto"});
    };
    const auto whole = drawn("off");
    const auto inParts = drawn("on");
    EXPECT_EQ(whole.parts.size(), 1U);
    // The same kernels on the same floats: only the compiler's folding of constants differs.
    const auto difference = compare(inParts.picture, whole.picture, 0.01);
    std::cout << GetParam().stem().string() << ": " << inParts.parts.size() << " parts, RMSE "
              << difference.rmse << ", " << difference.over << " pixels over 0.01\n";
    EXPECT_LT(difference.rmse, 0.0005)
        << saveForTheEye("parts-" + GetParam().stem().string(), inParts.picture, whole.picture);
    EXPECT_LE(difference.over, 3U);
    EXPECT_DOUBLE_EQ(inParts.raysPerSample, whole.raysPerSample);
}

TEST(PictureParts, OfRandomScenes_MissNoObject)
{
    std::size_t met = 0;
    for (unsigned seed = 0; seed < 25; ++seed) {
        const auto toml = randomScene(seed);
        Request request{96, 72, 1, {}, "auto"};
        request.view = DataView::object;
        const auto view = renderSceneText(toml, request).picture;
        const auto scene = parseScene(toml, glslFolder() / "scenes" / "text.toml", {}, 0.0, places());
        EXPECT_EQ(missed(scene, view, met), 0U) << "seed " << seed;
    }
    EXPECT_GT(met, 10000U);
}

TEST(PictureParts, TheStillLife_HasSkyAndMattePartsWithLessInTheirShaders)
{
    const auto still =
        renderScene(glslFolder() / "scenes" / "still_life.toml", {640, 360, 1, {"plan.tiles=on"}, "auto"});
    ASSERT_GT(still.parts.size(), 2U);
    double share = 0.0;
    for (const auto& part : still.parts)
        share += part.share;
    EXPECT_NEAR(share, 1.0, 1e-9);
    EXPECT_EQ(still.parts.front().name, "sky");
    EXPECT_FALSE(still.parts.front().plan.has("objects"));
    EXPECT_FALSE(still.parts[1].plan.has("mirror"));
    EXPECT_TRUE(still.parts[1].plan.has("shadows"));
    EXPECT_EQ(still.parts.back().name, "everything");
    for (std::size_t i = 1; i < still.parts.size(); ++i)
        EXPECT_LT(flatten(still.parts[i - 1].shader).size(), flatten(still.parts[i].shader).size());
}
