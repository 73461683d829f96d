// A renderer that goes on to another time draws what a fresh one would, bit for bit.
#include "support/rendering.h"

#include "base/file.h"
#include "render/renderer.h"
#include "scene/load.h"

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

ViewSettings smallView(DataView view = DataView::none)
{
    return {96, 54, 2, test::glslFolder(), {}, view};
}

// One scene at many times, by one renderer.
class Film
{
public:
    Film(const SceneOverTime& scene, double first_s, const ViewSettings& settings)
        : scene_(scene), settings_(settings), prepared_(prepare(scene(first_s), settings)),
          renderer_(prepared_, settings, contextFor("auto"))
    {
    }

    std::vector<float> at(double time_s)
    {
        moveTo(prepared_, scene_(time_s), settings_);
        renderer_.update(prepared_);
        return drawStill(renderer_, {0, 0, settings_.width, settings_.height}).picture.floats;
    }

    std::vector<float> freshAt(double time_s) const
    {
        return test::renderPrepared(prepare(scene_(time_s), settings_), settings_, "auto").picture.floats;
    }

private:
    SceneOverTime scene_;
    ViewSettings settings_;
    PreparedScene prepared_;
    Renderer renderer_;
};

void expectEachFrameIsAsFresh(const SceneOverTime& scene, const ViewSettings& settings)
{
    Film film(scene, 0.0, settings);
    const auto first = film.freshAt(0.0);
    for (const double time_s : {0.7, 1.7, 0.0}) {
        const auto frame = film.at(time_s);
        EXPECT_EQ(frame, film.freshAt(time_s)) << time_s;
        EXPECT_EQ(frame == first, time_s == 0.0) << "time changes the picture";
    }
}

SceneOverTime galleryScene(const std::string& name, const std::vector<std::string>& overrides = {})
{
    const auto path = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / (name + ".toml");
    return parseSceneOverTime(readFile(path), path, overrides, places());
}

// What an orrery lacks: a pictured sky that turns and brightens, so that the cut-off changes.
const std::string underAPicturedSky = R"(
[camera]
eye = [0, 1, 5]
target = [0, 0, 0]
[sky]
image = "sky.exr"
[material.glass]
ior = 1.5
transmit = 0.9
mirror = 0.05
absorption = [0.2, 0.1, 0.05]
[[sphere]]
centre = [0, 0, 0]
radius = 1
material = "glass"
[[animate]]
path = "sky.rotation_deg"
times = [0, 2]
values = [0, 90]
[[animate]]
path = "sky.exposure"
times = [0, 2]
values = [0, 4]
[[animate]]
path = "material.glass.absorption"
times = [0, 2]
values = [[0.2, 0.1, 0.05], [0.6, 0.1, 0.05]]
)";

} // namespace

TEST(Frames, AnUpdatedRenderer_DrawsWhatAFreshOneDraws)
{
    expectEachFrameIsAsFresh(galleryScene("orrery"), smallView());
}

TEST(Frames, AnUpdatedTableOfGeometry_IsThatOfAFreshRenderer)
{
    expectEachFrameIsAsFresh(galleryScene("orrery", {"trace.form=loop"}), smallView());
}

TEST(Frames, UnderAPicturedSky_TheCutOffGoesAlong)
{
    const auto path = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / "text.toml";
    expectEachFrameIsAsFresh(parseSceneOverTime(underAPicturedSky, path, {}, places()), smallView());
}

TEST(Frames, OfAView_AreThoseOfFreshRenderers)
{
    for (const auto view : {DataView::rays, DataView::depth})
        expectEachFrameIsAsFresh(galleryScene("orrery"), smallView(view));
}
