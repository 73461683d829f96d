// Every scene of the gallery by every rasterised method: it is drawn, all of it finite, by shaders that
// another compiler takes, too; and what rasterising does not fake is near the tracer's.
#include "raster/raster_text.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/glslang.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class Rasterised : public testing::TestWithParam<std::tuple<std::filesystem::path, std::string>>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Gallery, Rasterised,
                         testing::Combine(testing::ValuesIn(galleryScenes()),
                                          testing::Values("flat:16", "gouraud:16", "phong:32")),
                         [](const auto& info) {
                             std::string method = std::get<1>(info.param);
                             return std::get<0>(info.param).stem().string() + "_" +
                                    method.substr(0, method.find(':'));
                         });

TEST_P(Rasterised, Scene_IsDrawn)
{
    const auto& [scene, method] = GetParam();
    const Request request{160, 90, 1, ownPictures(scene), "auto", 0.0, DataView::none, method};
    const auto drawn = test::renderScene(scene, request);
    EXPECT_EQ(drawn.counts.nonfinite, 0U);
    EXPECT_GT(drawn.raster->drawn, 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    // No picture is another scene's: mirrors and glass differ, 77 % of `corridor`, and facets are coarse.
    Request traced = request;
    traced.method = "trace";
    const auto difference = compareEncoded(drawn.picture, test::renderScene(scene, traced).picture, 64.0);
    EXPECT_LT(static_cast<double>(difference.over), 0.85 * static_cast<double>(difference.pixels));
}

// RMSE of Phong's pictures where hardly anything mirrors or is clear: twice what was measured.
TEST(RasterisedGallery, WhatIsNotFaked_IsNearTheTracers)
{
    const std::map<std::string, double> bounds = {
        {"shadings", 0.02},  {"shadow_maps", 0.01}, {"spots", 0.006},       {"lights", 0.02},
        {"textures", 0.035}, {"highlights", 0.004}, {"light_types", 0.075}, {"cylinders", 0.066}};
    for (const auto& [name, bound] : bounds) {
        const auto scene = glslFolder() / "scenes" / (name + ".toml");
        Request request{160, 90, 1, ownPictures(scene), "auto", 0.0, DataView::none, "phong:32"};
        const auto drawn = test::renderScene(scene, request).picture;
        request.method = "trace";
        EXPECT_LT(compare(drawn, test::renderScene(scene, request).picture, 0.1).rmse, bound) << name;
    }
}

TEST_P(Rasterised, Shaders_AreTakenByAnotherCompiler)
{
    const auto& [scene, method] = GetParam();
    const ViewSettings view{160, 90, 1, glslFolder()};
    const RasterScene raster =
        prepareRaster(loadScene(scene, ownPictures(scene), 0.0, places()), view, methodNamed(method));
    const RasterTexts texts = rasterTexts(raster, glslFolder());
    std::map<std::string, std::string> files;
    const auto add = [&](const std::string& name, const RasterText& text) {
        if (!text.vertex.empty())
            files[name + ".vert"] = flatten(text.vertex);
        if (!text.fragment.empty())
            files[name + ".frag"] = flatten(text.fragment);
    };
    add("surface", texts.surface);
    add("sky", texts.sky);
    add("caster", texts.caster);
    add("wire", texts.wire);
    add("add", texts.add);
    EXPECT_EQ(complaints(files), "");
}
