// What the frames of a live host tell a plain shader.
#include "render/plain.h"
#include "support/in_a_folder.h"
#include "support/rendering.h"

#include <fstream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class PlainFrames : public InAFolder
{
protected:
    PlainRenderer rendererOf(const std::string& text, PlainSettings settings)
    {
        const auto& context = contextFor("auto");
        std::ofstream(folder / "a.frag") << text;
        return {folder / "a.frag", {1, 1, 1, glslFolder()}, std::move(settings), context};
    }
};

// Red, green and blue of the one pixel.
std::vector<float> colourOf(PlainRenderer& renderer)
{
    const auto still = drawStill(renderer, {0, 0, 1, 1});
    return {still.picture.floats[0], still.picture.floats[1], still.picture.floats[2]};
}

using Colour = std::vector<float>;

const std::string threeUniforms = "uniform float u_light_height; // 5\n"
                                  "uniform float u_gain; // 0.5 [0, 1]\n"
                                  "uniform float u_own = 0.25;\n"
                                  "void mainImage(out vec4 o, in vec2 p)\n"
                                  "{\n    o = vec4(u_light_height, u_gain, u_own, 1.0);\n}\n";

} // namespace

TEST_F(PlainFrames, LiveValues_TakeThePlaceOfTheShadersOwn_AndStayWhereTheyAreNoLongerSet)
{
    auto renderer = rendererOf(threeUniforms, {});
    EXPECT_EQ(colourOf(renderer), (Colour{5.0F, 0.5F, 0.25F}));
    PlainFrame frame;
    frame.live.lightHeight_m = 2.0;
    frame.live.sliders = {{"u_gain", {0.75}}, {"u_own", {1.0}}, {"u_nothing", {9.0}}};
    renderer.moveTo(frame);
    EXPECT_EQ(colourOf(renderer), (Colour{2.0F, 0.75F, 1.0F}));
    frame.live.lightHeight_m.reset();
    frame.live.sliders = {{"u_gain", {0.125}}};
    renderer.moveTo(frame);
    EXPECT_EQ(colourOf(renderer), (Colour{2.0F, 0.125F, 1.0F}));
}

TEST_F(PlainFrames, SetValues_GoBeforeLiveOnes)
{
    PlainSettings settings;
    settings.values = {{"u_light_height", "3"}, {"u_gain", "0.25"}};
    settings.frame.live.lightHeight_m = 2.0;
    settings.frame.live.sliders = {{"u_gain", {0.75}}};
    auto renderer = rendererOf(threeUniforms, std::move(settings));
    EXPECT_EQ(colourOf(renderer), (Colour{3.0F, 0.25F, 0.25F}));
}

TEST_F(PlainFrames, Pointer_IsTold)
{
    auto renderer = rendererOf(
        "void mainImage(out vec4 o, in vec2 p)\n{\n    o = vec4(iMouse.x, iMouse.zw, 1.0);\n}\n", {});
    EXPECT_EQ(colourOf(renderer), (Colour{0.0F, 0.0F, 0.0F}));
    PlainFrame frame;
    frame.pointer.press(3.5, 4.5);
    renderer.moveTo(frame);
    EXPECT_EQ(colourOf(renderer), (Colour{3.0F, 3.0F, 4.0F}));
    frame.pointer.nextFrame();
    frame.pointer.move(7.0, 7.0);
    renderer.moveTo(frame);
    EXPECT_EQ(colourOf(renderer), (Colour{7.0F, 3.0F, -4.0F}));
}
