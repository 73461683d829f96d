// --method of render and bench, and `dioptre compare --methods`.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class Methods : public InAFolder
{
protected:
    Outcome render(const std::string& words) const
    {
        return here("dioptre render " + words);
    }
    static nlohmann::json json(const Outcome& outcome)
    {
        return nlohmann::json::parse(outcome.out);
    }
    bool isThere(const std::string& name) const
    {
        return std::filesystem::exists(folder / name);
    }
};

// Bad words of the command line: the exit code, the message and its mend.
void expectRefused(const Outcome& outcome, const std::string& part)
{
    EXPECT_EQ(outcome.code, 2) << outcome.error;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
}

} // namespace

TEST_F(Methods, RenderRasterises_AndTellsWhatItTook)
{
    const auto outcome = render("shadow_maps --method phong:16 --size 96x54 --spp 2 -o a.png --json");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto figures = json(outcome);
    EXPECT_EQ(figures["method"], "phong:16");
    EXPECT_EQ(figures["rays_per_pixel"], 0.0);
    EXPECT_FALSE(figures.contains("beyond_trust"));
    const auto& raster = figures["raster"];
    EXPECT_GT(raster["objects_drawn"], 10);
    EXPECT_EQ(raster["shadow_maps"], 7);
    EXPECT_EQ(raster["shadow_map_px"], 1024);
    EXPECT_EQ(readPicture(folder / "a.png").width, 96);
    EXPECT_EQ(readSettings(folder / "a.png").at("dioptre.method"), "phong:16");
    const auto traced = json(render("shadow_maps --size 96x54 --spp 1 -o b.png --json"));
    EXPECT_EQ(traced["method"], "trace");
    EXPECT_FALSE(traced.contains("raster"));
}

TEST_F(Methods, WhatTheEyeDoesNotSee_IsCulledAndCounted)
{
    const auto all =
        json(render("shadow_maps --method flat:8 --size 64x36 --spp 1 -o a.png --json"))["raster"];
    const auto away = json(render("shadow_maps --method flat:8 --size 64x36 --spp 1 -o a.png --json "
                                  "--set 'camera.target=[-0.6, 9, 12]'"))["raster"];
    EXPECT_EQ(all["objects_culled"], 0);
    EXPECT_EQ(static_cast<int>(away["objects_culled"]) + static_cast<int>(away["objects_drawn"]),
              all["objects_drawn"]);
    EXPECT_GT(away["objects_culled"], 10);
    EXPECT_LT(away["triangles"], all["triangles"]);
}

TEST_F(Methods, BothStagesOfTheShaderAreWritten)
{
    const auto outcome = render("shadings --method gouraud:8 --size 16x9 --spp 1 -o a.png --shader s.frag");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_NE(readFile(folder / "s.vert").find("lightVertex("), std::string::npos);
    EXPECT_NE(readFile(folder / "s.frag").find("v_matt[0] * surface.colour"), std::string::npos);
}

TEST_F(Methods, WhyTellsThePatchOfAPlane)
{
    const auto vertices = render("shadow_maps --method gouraud:8 --size 64x36 --spp 1 -o a.png --why");
    EXPECT_NE(vertices.out.find("ground: 30 m on a side (raster_extent_m)"), std::string::npos)
        << vertices.out;
    const auto pixels = render("shadow_maps --method phong:8 --size 64x36 --spp 1 -o a.png --why");
    EXPECT_NE(pixels.out.find("their corners lie at infinity"), std::string::npos) << pixels.out;
    const auto usual = render("spheres --method flat:8 --size 64x36 --spp 1 -o a.png --why");
    EXPECT_EQ(usual.code, 0) << usual.error;
    EXPECT_EQ(usual.out.find("in   plane patches"), std::string::npos) << "it has no plane";
    const auto own = render("still_life --method flat:8 --size 64x36 --spp 1 -o a.png --why");
    EXPECT_NE(own.out.find("raster_extent_m sets another"), std::string::npos) << own.out;
}

TEST_F(Methods, TilesJoinBitForBit)
{
    const std::string words = "shadow_maps --method gouraud:16 --size 128x192 --spp 2 ";
    ASSERT_EQ(render(words + "-o whole.exr").code, 0);
    ASSERT_EQ(render(words + "--tile 1/3 -o t1.exr").code, 0);
    ASSERT_EQ(render(words + "--tile 2/3 -o t2.exr").code, 0);
    ASSERT_EQ(render(words + "--tile 3/3 -o t3.exr").code, 0);
    ASSERT_EQ(here("dioptre join t1.exr t2.exr t3.exr -o joined.exr").code, 0);
    EXPECT_EQ(readPicture(folder / "joined.exr").floats, readPicture(folder / "whole.exr").floats);
    ASSERT_EQ(render("shadow_maps --method phong:16 --size 128x192 --spp 2 --tile 3/3 -o other.exr").code, 0);
    EXPECT_NE(here("dioptre join t1.exr t2.exr other.exr -o no.exr").code, 0) << "tiles of two methods";
}

TEST_F(Methods, FramesMoveTheirShadows)
{
    const std::string words = "--method phong:16 --size 64x48 --spp 1 --fps 1 -o ";
    ASSERT_EQ(render("orrery --frames 0:2 " + words + "f.exr").code, 0);
    ASSERT_EQ(render("orrery --time 2 --method phong:16 --size 64x48 --spp 1 -o still.exr").code, 0);
    std::vector<std::filesystem::path> frames;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("f"))
            frames.push_back(entry.path());
    ASSERT_EQ(frames.size(), 3U);
    std::sort(frames.begin(), frames.end());
    EXPECT_EQ(readPicture(frames.back()).floats, readPicture(folder / "still.exr").floats);
}

TEST_F(Methods, BadOnesAreRefused_AndNothingIsWritten)
{
    const std::string scene = "shadings --size 16x9 --spp 1 -o no.png ";
    expectRefused(render(scene + "--method phong:4"), "8 to 512");
    expectRefused(render(scene + "--method phong:1000"), "8 to 512");
    expectRefused(render(scene + "--method toon:16"), "trace, flat:N, gouraud:N, phong:N");
    expectRefused(render(scene + "--method trace:16"), "without facets");
    expectRefused(render(scene + "--method phong:16 --reference"), "--reference");
    expectRefused(render(scene + "--method phong:16 --view normal"), "--view");
    expectRefused(render(scene + "--method phong:16 --budget 4"), "--budget");
    expectRefused(render("founding --method phong:16 --size 16x9 -o no.png"), "plain shader");
    const auto map = render(scene + "--method phong:16 --set raster.shadow_map=100");
    EXPECT_EQ(map.code, 65);
    EXPECT_NE(map.error.find("256 to 4096"), std::string::npos) << map.error;
    EXPECT_EQ(render(scene + "--method phong:16 --set raster.interfaces=3").code, 65);
    EXPECT_EQ(render(scene + "--method phong:16 --set raster.shadow_filter=soft").code, 65);
    EXPECT_EQ(render(scene + "--method phong:16 --set raster.shadow_bias=-1").code, 65);
    EXPECT_FALSE(isThere("no.png"));
}

TEST_F(Methods, CompareDrawsASheet_AndMeasures)
{
    const auto outcome =
        here("dioptre compare shadings --methods trace,flat:16,phong:32 --size 96x54 --spp 1 "
             "-o sheet.png --json");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto figures = json(outcome);
    EXPECT_EQ(figures["held_to"], "trace");
    const auto& methods = figures["methods"];
    ASSERT_EQ(methods.size(), 3U);
    EXPECT_EQ(methods[0]["rmse"], 0.0);
    EXPECT_EQ(methods[0]["ssim"], 1.0);
    EXPECT_GT(methods[1]["rmse"], methods[2]["rmse"]) << "flat is farther off than Phong";
    EXPECT_GT(methods[2]["rmse"], 0.0);
    EXPECT_LT(methods[1]["ssim"], methods[2]["ssim"]);
    for (const auto& method : methods) {
        EXPECT_GT(method["frame_ms"]["median"], 0.0);
        EXPECT_GE(method["ratio"]["high"], method["ratio"]["low"]);
    }
    EXPECT_EQ(methods[1]["raster"]["triangles"], 4096);
    const Picture sheet = readPicture(folder / "sheet.png");
    EXPECT_GT(sheet.width, 3 * 96);
    EXPECT_GT(sheet.height, 2 * 54);
}

// The same figures as comparing two pictures that render wrote.
TEST_F(Methods, CompareAgreesWithPicturesThatRenderWrote)
{
    ASSERT_EQ(render("shadings --size 96x54 --spp 2 -o a.exr").code, 0);
    ASSERT_EQ(render("shadings --method flat:8 --size 96x54 --spp 2 -o b.exr").code, 0);
    const auto files = json(here("dioptre compare a.exr b.exr --json"));
    const auto methods =
        json(here("dioptre compare shadings --methods trace,flat:8 --size 96x54 --spp 2 --json"))["methods"];
    EXPECT_NEAR(methods[1]["rmse"], files["linear"]["rmse"], 1e-9);
    EXPECT_NEAR(methods[1]["ssim"], files["display"]["ssim"], 1e-9);
}

TEST_F(Methods, CompareWipesAndMapsTwo)
{
    const std::string words = "dioptre compare shadings --methods trace,flat:8 --size 96x54 --spp 1 ";
    ASSERT_EQ(here(words + "--wipe 0.5 -o wipe.png").code, 0);
    ASSERT_EQ(render("shadings --size 96x54 --spp 1 -o a.png").code, 0);
    ASSERT_EQ(render("shadings --method flat:8 --size 96x54 --spp 1 -o b.png").code, 0);
    const Picture wipe = readPicture(folder / "wipe.png");
    const Picture left = readPicture(folder / "a.png");
    const Picture right = readPicture(folder / "b.png");
    ASSERT_EQ(wipe.width, 96);
    std::size_t differ = 0;
    for (int y = 0; y < 30; ++y) // below the titles
        for (int x = 0; x < 96; ++x) {
            if (x >= 46 && x < 50)
                continue; // the line
            const auto i = static_cast<std::size_t>(4 * (96 * y + x));
            const Picture& half = x < 48 ? left : right;
            for (std::size_t c = 0; c < 3; ++c)
                differ += wipe.bytes[i + c] == half.bytes[i + c] ? 0 : 1;
        }
    EXPECT_EQ(differ, 0U);
    ASSERT_EQ(here(words + "--difference -o map.png").code, 0);
    const Picture map = readPicture(folder / "map.png");
    ASSERT_EQ(map.width, 96);
    std::size_t wrong = 0; // not black where the two are one, or black where they are far apart
    for (std::size_t i = 0; i < map.bytes.size(); i += 4) {
        int apart = 0;
        for (std::size_t c = 0; c < 3; ++c)
            apart = std::max(apart, std::abs(left.bytes[i + c] - right.bytes[i + c]));
        const int light = map.bytes[i] + map.bytes[i + 1] + map.bytes[i + 2];
        wrong += (apart == 0 && light > 60) || (apart > 100 && light < 60) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0U);
}

TEST_F(Methods, CompareRefusesWhatMakesNoSense)
{
    const std::string words = "dioptre compare shadings --size 16x9 --spp 1 -o no.png ";
    expectRefused(here(words + "--methods trace"), "one method");
    expectRefused(here(words + "--methods trace,trace"), "twice");
    expectRefused(here(words + "--methods trace,phong:9999"), "8 to 512");
    expectRefused(here(words + "--methods trace,flat:8,phong:8 --wipe 0.5"), "two methods");
    expectRefused(here(words + "--methods trace,flat:8 --wipe 1.5"), "0 to 1");
    expectRefused(here(words + "--methods trace,flat:8 --ppd 5"), "--ppd");
    expectRefused(here(words + "--methods trace,flat:8 --exposure nan"), "--exposure");
    expectRefused(here(words + "--methods trace,flat:8 --time nan"), "--time");
    expectRefused(here(words + "--methods trace,flat:8 --wipe 0.5 --difference"), "leave one of them out");
    expectRefused(here("dioptre compare shadings --methods trace,flat:8 --wipe 0.5"), "-o FILE.png");
    expectRefused(here("dioptre compare shadings --methods trace,flat:8 -o no.exr"), ".png");
    expectRefused(here("dioptre compare founding --methods trace,flat:8"), "plain shader");
    expectRefused(here("dioptre compare shadings"), "--methods");
    expectRefused(here("dioptre compare a.png b.png --spp 8"), "two pictures");
    expectRefused(here("dioptre compare shadings b.png --methods trace,flat:8"), "two inputs");
    EXPECT_FALSE(isThere("no.png"));
    EXPECT_FALSE(isThere("no.exr"));
}

TEST_F(Methods, BenchHoldsThemToEachOther)
{
    const auto outcome =
        here("dioptre bench shadings shadings@method=phong:16 shadings@method=flat:8,trace.budget=1 "
             "--size 32x18 --frames 6 --cold 1 --json");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto inputs = json(outcome)["inputs"];
    ASSERT_EQ(inputs.size(), 3U);
    EXPECT_GT(inputs[0]["rays_per_pixel"], 0.0);
    EXPECT_EQ(inputs[1]["rays_per_pixel"], 0.0);
    EXPECT_EQ(inputs[1]["name"], "shadings@method=phong:16");
    EXPECT_EQ(json(here("dioptre bench shadings --method flat:8 --size 32x18 --frames 6 --cold 1 --json"))
                  ["inputs"][0]["rays_per_pixel"],
              0.0);
    expectRefused(here("dioptre bench shadings@method=phong:1"), "8 to 512");
    expectRefused(here("dioptre bench founding --method phong:16"), "plain shader");
    expectRefused(here("dioptre bench shadings --method phong:16 --reload"), "--reload");
    expectRefused(here("dioptre bench shadings --method phong:16 --python"), "--python");
}
