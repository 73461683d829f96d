// A picture that refines itself sample by sample, a few rows at a time, is the one drawn at once.
#include "render/plain.h"
#include "render/renderer.h"
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

constexpr int refinedWidth = 192, refinedHeight = 100;

// Bands of uneven heights, as a window's time allows: a sample is whole before the next.
std::vector<float> bitByBit(Drawing& drawing, int samples)
{
    drawing.start();
    int rows = 1;
    for (int sample = 0; sample < samples; ++sample)
        for (int y = 0; y < refinedHeight; y += rows, rows = 1 + (7 * rows + 3) % 40)
            drawing.add({sample, 1}, {0, y, refinedWidth, std::min(rows, refinedHeight - y)});
    return drawing.read().floats;
}

std::vector<float> drawnAtOnce(Drawing& drawing)
{
    drawing.draw();
    return drawing.read().floats;
}

void expectSampleBySampleIsTheWhole(const std::string& name, const std::vector<std::string>& overrides,
                                    bool hasParts)
{
    const ViewSettings view{refinedWidth, refinedHeight, 4, glslFolder()};
    const auto scene = loadScene(glslFolder() / "scenes" / (name + ".toml"), overrides, 0.0, places());
    const auto prepared = prepare(scene, view);
    EXPECT_EQ(prepared.parts.size() > 1, hasParts) << name;
    Renderer renderer(prepared, view, contextFor("auto"));
    const auto expected = drawnAtOnce(renderer);
    EXPECT_NE(expected, std::vector<float>(expected.size(), expected.front()));
    EXPECT_EQ(bitByBit(renderer, view.samples), expected) << name;
    EXPECT_EQ(bitByBit(renderer, view.samples), expected) << name << ", once more";
}

class SampleBySample : public InAFolder
{
};

} // namespace

TEST_F(SampleBySample, SceneOfSeveralParts_IsThePictureDrawnAtOnce)
{
    expectSampleBySampleIsTheWhole("still_life", {"plan.tiles=on"}, true);
    expectSampleBySampleIsTheWhole("glass", {"plan.tiles=on", "trace.budget=8"}, true);
}

TEST_F(SampleBySample, SceneOfOnePart_IsThePictureDrawnAtOnce)
{
    expectSampleBySampleIsTheWhole("glass", {"plan.tiles=off", "trace.budget=8"}, false);
}

TEST_F(SampleBySample, FewerSamples_AreThePictureOfSoMany)
{
    const auto scene = loadScene(glslFolder() / "scenes" / "spheres.toml", {}, 0.0, places());
    ViewSettings view{refinedWidth, refinedHeight, 4, glslFolder()};
    const auto ofFour = prepare(scene, view);
    Renderer four(ofFour, view, contextFor("auto"));
    const auto first = bitByBit(four, 1);
    view.samples = 1;
    const auto ofOne = prepare(scene, view);
    Renderer one(ofOne, view, contextFor("auto"));
    EXPECT_EQ(first, drawnAtOnce(one));
}

TEST_F(SampleBySample, PlainShader_IsThePictureDrawnAtOnce)
{
    const auto shader = folder / "places.frag";
    std::ofstream(shader) << "void mainImage(out vec4 c, in vec2 p) {\n"
                             "    c = vec4(sin(p * 0.37), fwidth(p.x * p.y), 1.0);\n"
                             "}\n";
    PlainRenderer renderer(shader, {refinedWidth, refinedHeight, 1, glslFolder()}, {}, contextFor("auto"));
    const auto expected = drawnAtOnce(renderer);
    EXPECT_NE(expected[0], expected[4]);
    EXPECT_EQ(bitByBit(renderer, 1), expected);
}

} // namespace dioptre::test
