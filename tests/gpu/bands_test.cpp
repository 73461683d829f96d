// A picture drawn in parts is the picture drawn at once, bit for bit.
#include "kernel/reference.h"
#include "render/layers.h"
#include "render/plain.h"
#include "render/still.h"
#include "scene/load.h"
#include "support/in_a_folder.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace dioptre::test
{
namespace
{

constexpr int width = 200, height = 168; // neither is a multiple of the parts' sides

ViewSettings viewInParts(int samples, DataView data = DataView::none)
{
    ViewSettings view{width, height, samples, glslFolder(), {}, data};
    view.widthAtOnce = 64;
    view.heightAtOnce = 64;
    return view;
}

// The bands of a drawing one above the other, as drawn one after the other.
Picture inBands(Drawing& drawing)
{
    Picture all = blankFloats(width, height);
    for (int y = 0; y < height; y += 64) {
        const Still band = drawStill(drawing, {0, y, width, std::min(64, height - y)});
        std::ranges::copy(band.picture.floats, all.floats.begin() + 4L * width * y);
    }
    return all;
}

Picture atOnce(Drawing& drawing)
{
    return drawStill(drawing, {0, 0, width, height}).picture;
}

void expectPartsAreTheWhole(const Scene& scene, const ViewSettings& parts)
{
    const auto& context = contextFor("auto");
    ViewSettings whole = parts;
    whole.widthAtOnce = whole.heightAtOnce = 0;
    const auto prepared = prepare(scene, parts);
    Renderer asParts(prepared, parts, context);
    Renderer asWhole(prepared, whole, context);
    const auto expected = atOnce(asWhole).floats;
    EXPECT_EQ(inBands(asParts).floats, expected);
    EXPECT_NE(expected, std::vector<float>(expected.size(), expected.front()));
}

Scene gallery(const std::string& name, const std::vector<std::string>& overrides)
{
    return loadScene(glslFolder() / "scenes" / (name + ".toml"), overrides, 0.0, places());
}

TEST(Bands, OfAScene_AreThePictureDrawnAtOnce)
{
    expectPartsAreTheWhole(gallery("still_life", {"plan.tiles=on"}), viewInParts(4));
    expectPartsAreTheWhole(gallery("glass", {"plan.tiles=off"}), viewInParts(2));
    expectPartsAreTheWhole(gallery("crowd", {"trace.form=loop"}), viewInParts(1));
}

TEST(Bands, OfAViewsData_AreThoseDrawnAtOnce)
{
    expectPartsAreTheWhole(gallery("still_life", {}), viewInParts(2, DataView::depth));
    expectPartsAreTheWhole(gallery("still_life", {}), viewInParts(2, DataView::normal));
}

TEST(Bands, OfLayers_AreThoseDrawnAtOnce)
{
    const Scene scene = gallery("still_life", {});
    const auto rows = layersNamed({"depth", "normal", "object"});
    ViewSettings whole = viewInParts(2);
    whole.widthAtOnce = whole.heightAtOnce = 0;
    const auto expected = LayerDrawer(scene, rows, whole, contextFor("auto")).draw({0, 0, width, height});
    const LayerDrawer parts(scene, rows, viewInParts(2), contextFor("auto"));
    const auto band = parts.draw({0, 64, width, 64});
    ASSERT_EQ(band.size(), expected.size());
    for (std::size_t i = 0; i < band.size(); ++i) {
        const auto first = expected[i].numbers.begin() + 64L * width;
        EXPECT_EQ(band[i].channel, expected[i].channel);
        EXPECT_EQ(band[i].numbers, std::vector<float>(first, first + 64L * width));
    }
}

TEST(Bands, OfTheReference_AreItsPicture)
{
    const auto prepared = prepare(gallery("glass", {}), viewInParts(2));
    const auto whole = renderReference(prepared.packed, 40, 30, 2, {0, 0, 40, 30});
    const auto part = renderReference(prepared.packed, 40, 30, 2, {8, 10, 20, 5});
    for (std::size_t y = 0; y < 5; ++y)
        for (std::size_t i = 0; i < 80; ++i)
            ASSERT_EQ(part.floats[80 * y + i], whole.floats[160 * (y + 10) + 32 + i]);
}

// Places, derivatives over two pixels, and mip levels, which come from them.
class BandsOfAPlainShader : public InAFolder
{
};

TEST_F(BandsOfAPlainShader, AreThePictureDrawnAtOnce)
{
    const auto shader = folder / "places.frag";
    std::ofstream(shader) << "#define P gl_FragCoord.xy / iResolution.xy\n"
                             "vec2 global;\n"
                             "void mainImage(out vec4 c, in vec2 p) {\n"
                             "    global = P;\n"
                             "    c = vec4(p + dFdx(p * p), fwidth(sin(global.x * 90.0 * global.y)), 1.0);\n"
                             "    c.b += texture(iChannel0, p * p * 1e-3).g;\n"
                             "}\n";
    PlainSettings plain;
    plain.channels[0].files = {std::string(DIOPTRE_SOURCE_DIR) + "/textures/planet.png"};
    ViewSettings parts = viewInParts(1);
    PlainRenderer asParts(shader, parts, plain, contextFor("auto"));
    parts.widthAtOnce = parts.heightAtOnce = 0;
    PlainRenderer asWhole(shader, parts, plain, contextFor("auto"));
    const auto expected = atOnce(asWhole).floats;
    EXPECT_EQ(inBands(asParts).floats, expected);
    EXPECT_NE(expected[4], expected[8]);
}

TEST(DrawPacer, AreaAndAnyTimes_EachPixelIsDrawnOnceAndFewDrawsAreUnderWay)
{
    contextFor("auto");
    DrawPacer pacer(30.0);
    for (int picture = 0; picture < 3; ++picture) { // draws grow from one to the next
        std::vector<int> drawn(static_cast<std::size_t>(3000 * 2000));
        double told = 0.0;
        std::size_t draws = 0;
        std::size_t underWay = 0; // draws that were not waited for
        pacer.begin(3000L * 2000, [&](double share) {
            told = share;
            underWay = 0;
        });
        for (const auto& area : {PixelRectangle{0, 0, 3000, 33}, PixelRectangle{0, 33, 2650, 1967},
                                 PixelRectangle{2650, 33, 350, 1967}})
            pacer.cover(area, [&](const PixelRectangle& r) {
                ++draws;
                EXPECT_LE(++underWay, 4U) << "those that follow may cost a thousand times as much";
                for (int y = r.y; y < r.y + r.height; ++y)
                    for (int x = r.x; x < r.x + r.width; ++x)
                        ++drawn[static_cast<std::size_t>(y * 3000 + x)];
            });
        pacer.finish();
        EXPECT_EQ(drawn, std::vector<int>(drawn.size(), 1));
        EXPECT_EQ(told, 1.0);
        EXPECT_GT(draws, 3U);
    }
}

} // namespace
} // namespace dioptre::test
