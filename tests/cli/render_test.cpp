// The command as a user types it.
#include "base/file.h"
#include "support/compare.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace dioptre;
using dioptre::test::run;

namespace
{

using RenderCommand = test::InAFolder;

} // namespace

TEST_F(RenderCommand, GalleryScene_BecomesAPngOfTheAskedSize)
{
    const auto outcome = here("dioptre render still_life --size 32x18 --spp 1 -o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    const auto picture = readPicture(folder / "a.png");
    EXPECT_EQ(picture.width, 32);
    EXPECT_EQ(picture.height, 18);
}

TEST_F(RenderCommand, WithoutOutput_NamesThePictureAfterTheScene)
{
    EXPECT_EQ(here("dioptre render cylinders --size 16x9 --spp 1").code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "cylinders.png"));
}

TEST_F(RenderCommand, TwoRuns_GiveTheSameBytes)
{
    ASSERT_EQ(here("dioptre render still_life --size 64x36 --spp 2 -o a.png && dioptre render still_life "
                   "--size 64x36 --spp 2 "
                   "-o b.png && cmp a.png b.png")
                  .code,
              0);
}

TEST_F(RenderCommand, Png_CarriesItsSettings)
{
    const auto outcome = here("dioptre render still_life --size 16x9 --spp 3 --set trace.form=loop --budget "
                              "5 -o a.png && strings a.png");
    for (const char* text :
         {"dioptre.spp", "dioptre.backend", "egl-surfaceless", "trace.form=loop", "trace.budget=5", "16x9"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST_F(RenderCommand, Time_IsThatOfThePictureOfItsSettingsAndOfTheFigures)
{
    const auto outcome =
        here("dioptre render orrery --size 64x36 --spp 1 -o 0.png && dioptre render orrery --size "
             "64x36 --spp 1 --time 2.5 --json -o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["time_s"], 2.5);
    EXPECT_NE(here("strings a.png").out.find("dioptre.time"), std::string::npos);
    EXPECT_NE(readPicture(folder / "0.png").bytes, readPicture(folder / "a.png").bytes);
    // The scene loops in 12 s.
    ASSERT_EQ(here("dioptre render orrery --size 64x36 --spp 1 --time -9.5 -o b.png").code, 0);
    EXPECT_EQ(readPicture(folder / "b.png").bytes, readPicture(folder / "a.png").bytes);
}

TEST_F(RenderCommand, Reference_DrawsTheTimeThatIsAsked)
{
    const auto outcome =
        here("dioptre render orrery --size 32x18 --spp 1 --time 5 -o a.exr && dioptre render "
             "orrery --size 32x18 --spp 1 --time 5 --reference -o b.exr");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_LT(test::compare(readPicture(folder / "a.exr"), readPicture(folder / "b.exr"), 0.01).rmse, 0.01);
}

TEST_F(RenderCommand, PlainShader_IsFedTheTime)
{
    ASSERT_EQ(
        here(
            "printf 'uniform float u_time;\\nout vec4 o;\\nvoid main()\\n{\\n    o = vec4(u_time, 0.25, 0.0, "
            "1.0);\\n}\\n' >p.frag && dioptre render p.frag --size 4x2 --time 0.5 -o a.exr && dioptre "
            "render p.frag --size 4x2 -o 0.exr")
            .code,
        0);
    EXPECT_EQ(readPicture(folder / "a.exr").floats[0], 0.5F);
    EXPECT_EQ(readPicture(folder / "0.exr").floats[0], 0.0F);
}

TEST_F(RenderCommand, EachSet_TakesOneValue_WhereverItStands)
{
    const auto outcome =
        here("dioptre render --set trace.form=loop --set trace.budget=2 still_life --size 16x9 --spp 1 --why "
             "-o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("in   geometry table"), std::string::npos);
    EXPECT_NE(outcome.out.find("budget    2 rays"), std::string::npos);
}

TEST_F(RenderCommand, PlainShader_MayNameItsVersion)
{
    EXPECT_EQ(here("printf '#version 330 core\\nout vec4 o;\\nvoid main()\\n{\\n    o = vec4(1.0);\\n}\\n' "
                   ">p.frag && "
                   "dioptre render p.frag --size 4x2 -o p.png")
                  .code,
              0);
}

TEST_F(RenderCommand, Exr_HoldsTheLinearRadianceOfThePng)
{
    ASSERT_EQ(here("dioptre render still_life --size 64x36 --spp 2 -o a.png && dioptre render still_life "
                   "--size 64x36 --spp 2 "
                   "-o a.exr")
                  .code,
              0);
    const auto exr = readPicture(folder / "a.exr");
    ASSERT_EQ(exr.format, PixelFormat::float32);
    // Encoding the EXR's numbers gives the PNG's bytes exactly: one function encodes both.
    EXPECT_EQ(test::compareEncoded(exr, test::decoded(readPicture(folder / "a.png")), 0.5).over, 0U);
    EXPECT_GT(*std::max_element(exr.floats.begin(), exr.floats.end()), 1.0F)
        << "radiance above white is kept";
}

TEST_F(RenderCommand, Budget_ChangesWhatIsTraced)
{
    const auto few = nlohmann::json::parse(
        here("dioptre render glass --size 64x36 --spp 1 --budget 2 --json -o a.png").out);
    const auto many = nlohmann::json::parse(
        here("dioptre render glass --size 64x36 --spp 1 --budget 32 --json -o a.png").out);
    EXPECT_LE(few["rays_per_pixel"], 2.0);
    EXPECT_GT(many["rays_per_pixel"], few["rays_per_pixel"]);
}

TEST_F(RenderCommand, Json_HoldsEveryFigure)
{
    const auto outcome = here("dioptre render still_life --size 48x27 --spp 2 --json -o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["size"], nlohmann::json({48, 27}));
    EXPECT_EQ(json["samples"], 2);
    EXPECT_EQ(json["backend"], "egl-surfaceless");
    for (const char* phase : {"context", "load", "compile", "first_draw", "draw", "read", "write"})
        EXPECT_GT(json["phases_ms"][phase].get<double>(), 0.0) << phase;
    double sum = 0.0;
    for (const auto& phase : json["phases_ms"])
        sum += phase.get<double>();
    EXPECT_GE(json["total_ms"].get<double>(), sum) << "phases follow one another";
    EXPECT_GT(json["rays_per_pixel"], 2.0);
    EXPECT_EQ(json["nonfinite_pixels"], 0);
}

TEST_F(RenderCommand, Why_TellsWhatIsInAndOutAndWhy)
{
    const auto out = here("dioptre render cylinders --size 16x9 --spp 1 --why -o a.png").out;
    for (const char* text :
         {"in   open cylinder", "out  triangle", "no such object", "shader ", "compile ", "first draw"})
        EXPECT_NE(out.find(text), std::string::npos) << text << " not in\n" << out;
}

TEST_F(RenderCommand, PartsOfThePicture_AreToldAndTheirShadersWritten)
{
    const std::string settings = " --size 320x180 --spp 1 --set plan.tiles=on ";
    const auto outcome = here("dioptre render still_life" + settings + "--why --shader a.frag -o a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("parts     sky "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.error.find("a-1.frag: the shader where the picture shows sky"), std::string::npos)
        << outcome.error;
    const auto sky = readFile(folder / "a-1.frag");
    EXPECT_EQ(sky.find("sphereSpan"), std::string::npos) << sky;
    EXPECT_NE(sky.find("out  objects                        none is seen"), std::string::npos) << sky;
    EXPECT_NE(readFile(folder / "a.frag").find("sphereSpan"), std::string::npos);
}

TEST_F(RenderCommand, Why_TellsTheScenesPlan_WhereThePictureShowsTheSkyAlone)
{
    const auto out = here("dioptre render still_life --size 160x90 --spp 1 --set plan.tiles=on "
                          "--set camera.target=[0,90,5] --why -o a.png")
                         .out;
    for (const char* text :
         {"in   mirror", "budget    16", "parts     sky 100.0 %", "textures  u_sky_picture ("})
        EXPECT_NE(out.find(text), std::string::npos) << text << " not in\n" << out;
}

TEST_F(RenderCommand, AFileNameThatIsNotUtf8_LeavesJsonWhole)
{
    const auto outcome =
        here("dioptre render spheres --size 16x9 --spp 1 --json -o \"$(printf '\\377').png\"");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["size"][0], 16);
}

TEST_F(RenderCommand, OsMesa_IsNamedWhereItRan)
{
    const auto outcome = here("dioptre render still_life --size 16x9 --spp 1 --backend osmesa -o a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("osmesa"), std::string::npos) << outcome.error;
}

TEST_F(RenderCommand, WithoutEglDrivers_AutoFallsBackToOsMesa)
{
    const auto outcome =
        here("__EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre render still_life --size 16x9 --spp 1 -o a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("osmesa"), std::string::npos) << outcome.error;
}

TEST_F(RenderCommand, Reference_DrawsTheSceneWithoutOpenGl)
{
    const auto outcome =
        here("dioptre render still_life --size 32x18 --spp 1 -o a.exr && LIBGL_DRIVERS_PATH=/nowhere "
             "dioptre render still_life --size 32x18 --spp 1 --reference -o b.exr");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_LT(test::compare(readPicture(folder / "a.exr"), readPicture(folder / "b.exr"), 0.01).rmse, 0.01);
}

TEST_F(RenderCommand, PlainShader_IsDrawnUnencodedAndUpright)
{
    // Red grows to the right, green upwards.
    const auto outcome = here("printf 'uniform vec2 u_resolution;\\nout vec4 o;\\nvoid main()\\n{\\n    o = "
                              "vec4(gl_FragCoord.xy / u_resolution, 0.0, 1.0);\\n}\\n' >p.frag && "
                              "dioptre render p.frag --size 4x2 -o p.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto picture = readPicture(folder / "p.png");
    // Row 0 is the bottom; (0.5/4, 0.5/2) of 255, rounded.
    EXPECT_EQ(picture.bytes[0], 32);
    EXPECT_EQ(picture.bytes[1], 64);
    EXPECT_EQ(picture.bytes[4 * 7], 223);
    EXPECT_EQ(picture.bytes[(4 * 7) + 1], 191);
}
