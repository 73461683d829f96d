// What loading brings for the methods that draw a scene, before there is a device.
#include "live/load_once.h"

#include "support/in_a_folder.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace dioptre::test
{
namespace
{

const std::string text = "[[light]]\nkind = \"point\"\nposition = [2, 3, 4]\n[[sphere]]\ncentre = [0, 0, 0]\n"
                         "radius = 1\n[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n";

class LoadRaster : public InAFolder
{
protected:
    LoadRaster()
    {
        std::ofstream(folder / "a.toml") << text;
        request.look.input.path = folder / "a.toml";
        request.look.places = places();
        request.look.size_px = {64, 48};
    }
    LoadOutcome load(const std::vector<Method>& methods)
    {
        request.look.methods = methods;
        LoadOutcome outcome = loadOnce(request, {}, kept);
        EXPECT_FALSE(outcome.error) << outcome.error->what();
        return outcome;
    }
    static bool watches(const LoadOutcome& outcome, const char* file)
    {
        return std::ranges::find(outcome.files, places().glslFolder / file) != outcome.files.end();
    }

    LoadRequest request;
    KeptForMethods kept;
};

const Method flat{Shading::flat, 8}, finer{Shading::flat, 16}, phong{Shading::phong, 8};

} // namespace

TEST_F(LoadRaster, OfTheTracerAlone_NothingRasterised_IsMadeOrWatched)
{
    const LoadOutcome outcome = load({Method{}});
    EXPECT_FALSE(outcome.loaded->scene->parts.empty());
    EXPECT_FALSE(outcome.loaded->scene->rasters.front());
    EXPECT_FALSE(watches(outcome, "raster/surface.frag"));
}

TEST_F(LoadRaster, OfFacetsAlone_NoTracer_AndEverySourceIsWatched)
{
    const LoadOutcome outcome = load({phong});
    EXPECT_TRUE(outcome.loaded->scene->parts.empty());
    EXPECT_TRUE(outcome.loaded->scene->rasters.front());
    for (const auto& each : std::filesystem::directory_iterator(places().glslFolder / "raster"))
        EXPECT_TRUE(watches(outcome, ("raster/" + each.path().filename().string()).c_str())) << each.path();
    EXPECT_TRUE(watches(outcome, "trace/light.glsl"));
    const auto& trials = outcome.loaded->trials;
    EXPECT_EQ(trials.size(), 5U) << "surfaces, sky, casters, edges, sums";
    const auto placing =
        std::ranges::count_if(trials, [](const auto& t) { return !t.program.vertex.empty(); });
    const auto fed = std::ranges::count_if(trials, [](const auto& t) { return !t.program.corners.empty(); });
    EXPECT_EQ(placing, 3);
    EXPECT_EQ(fed, placing) << "a stage without corners would draw nothing";
}

TEST_F(LoadRaster, WhatIsOnTheDevice_IsNotTriedAgain_AndMoreFacetsNeedNoCompiler)
{
    const LoadOutcome both = load({Method{}, flat});
    request.onDevice = both.loaded->drawn;
    EXPECT_TRUE(load({Method{}, flat}).loaded->trials.empty());
    const LoadOutcome more = load({finer, Method{}});
    EXPECT_TRUE(more.loaded->trials.empty());
    EXPECT_TRUE(needsNoCompiler(*more.loaded, *both.loaded));
    const LoadOutcome other = load({Method{}, phong});
    EXPECT_EQ(other.loaded->trials.size(), 5U);
    EXPECT_FALSE(needsNoCompiler(*other.loaded, *both.loaded));
}

} // namespace dioptre::test
