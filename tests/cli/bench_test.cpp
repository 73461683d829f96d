// `dioptre bench` as a user types it. What is timed is never asserted, only that it is there and whose it is.
#include "support/in_a_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using dioptre::test::InAFolder;
using dioptre::test::Outcome;

namespace
{

// A glass ball before a sky: small shaders, so that the tests are short.
const char* const ball = R"([sky]
colour = [0.5, 0.6, 0.7]
[camera]
eye = [0.0, 0.0, 2.0]
target = [0.0, 0.0, 0.0]
[material.glass]
transmit = 1.0
ior = 1.5
[[sphere]]
centre = [0.0, 0.0, 0.0]
radius = 1.0
material = "glass"
)";

// Runs in a folder of its own, with the smallest of measurements.
class BenchCommand : public InAFolder
{
protected:
    BenchCommand()
    {
        std::ofstream(folder / "ball.toml") << ball;
        std::filesystem::create_directory(folder / "me@home");
        std::ofstream(folder / "me@home" / "a@b.toml") << ball;
    }
    Outcome here(const std::string& command) const
    {
        return InAFolder::here("SOURCES='" DIOPTRE_SOURCE_DIR "' && " + command);
    }
    Outcome bench(const std::string& inputs) const
    {
        return here("dioptre bench --size 24x24 --frames 3 --cold 1 " + inputs);
    }
    nlohmann::json json(const std::string& inputs) const
    {
        const auto outcome = bench("--json " + inputs);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        return nlohmann::json::parse(outcome.out);
    }
};

} // namespace

TEST_F(BenchCommand, Json_HoldsEveryFigure)
{
    const auto figures = json("ball.toml ball.toml@trace.form=loop");
    EXPECT_FALSE(figures["renderer"].get<std::string>().empty());
    EXPECT_EQ(figures["backend"], "egl-surfaceless");
    EXPECT_EQ(figures["size"], nlohmann::json({24, 24}));
    EXPECT_EQ(figures["samples"], 1);
    EXPECT_EQ(figures["frames"], 3);
    EXPECT_GE(figures["warm_up_frames"], 5);
    ASSERT_EQ(figures["inputs"].size(), 2U);
    for (const auto& input : figures["inputs"]) {
        EXPECT_GT(input["frame_ms"]["median"], 0.0);
        EXPECT_LE(input["frame_ms"]["low"], input["frame_ms"]["median"]);
        EXPECT_GE(input["frame_ms"]["high"], input["frame_ms"]["median"]);
        EXPECT_EQ(input["rounds"]["frame_ms"].size(), 3U);
        for (const char* key : {"compile_ms", "first_draw_ms", "peak_mib", "ratio"})
            EXPECT_GT(input[key], 0.0) << key;
        EXPECT_GE(input["rays_per_pixel"], 1.0);
        for (const char* key : {"frame", "compile", "first_draw", "compile_through_first_draw", "peak"})
            EXPECT_TRUE(input["ratios"][key]["differs"].is_boolean()) << key;
    }
}

// llvmpipe's timer queries lie.
TEST_F(BenchCommand, Clock_IsTheMonotonicOneOnASoftwareDriver)
{
    const auto figures = json("ball.toml");
    if (figures["renderer"].get<std::string>().find("llvmpipe") != std::string::npos)
        EXPECT_EQ(figures["clock"], "glFinish and the monotonic clock");
    else
        EXPECT_FALSE(figures["clock"].get<std::string>().empty());
}

TEST_F(BenchCommand, FirstInput_IsWhatTheOthersAreHeldTo)
{
    const auto figures = json("ball.toml cylinders");
    EXPECT_EQ(figures["inputs"][0]["name"], "ball.toml");
    EXPECT_EQ(figures["inputs"][1]["name"], "cylinders");
    EXPECT_EQ(figures["inputs"][0]["ratio"], 1.0);
    EXPECT_EQ(figures["inputs"][0]["ratios"]["frame"]["differs"], false);
    const double first = figures["inputs"][0]["frame_ms"]["median"];
    const double second = figures["inputs"][1]["frame_ms"]["median"];
    EXPECT_DOUBLE_EQ(figures["inputs"][1]["ratio"], second / first);
}

TEST_F(BenchCommand, Control_IsTheFirstInputAgain)
{
    const auto control = json("ball.toml")["control"];
    EXPECT_EQ(control["name"], "ball.toml, again");
    EXPECT_EQ(control["rounds"]["frame_ms"].size(), 3U);
    for (const char* key : {"frame", "compile", "first_draw", "compile_through_first_draw", "peak"})
        EXPECT_GE(control["spread"][key], 0.0) << key;
}

TEST_F(BenchCommand, Overrides_ChangeWhatIsTraced)
{
    const auto inputs =
        json("ball.toml 'ball.toml@trace.budget=1,sky.colour=[1,0,0]' ball.toml@trace.budget=1")["inputs"];
    EXPECT_EQ(inputs[1]["name"], "ball.toml@trace.budget=1,sky.colour=[1,0,0]");
    EXPECT_GT(inputs[0]["rays_per_pixel"], 1.5);
    EXPECT_EQ(inputs[1]["rays_per_pixel"], 1.0);
    EXPECT_EQ(inputs[2]["rays_per_pixel"], 1.0);
}

TEST_F(BenchCommand, MoreSamples_TraceAsManyRaysMore)
{
    EXPECT_EQ(json("ball.toml@trace.budget=1 --spp 3")["inputs"][0]["rays_per_pixel"], 3.0);
}

TEST_F(BenchCommand, AtSignsInPathsAndValues_AreTheirOwn)
{
    const auto inputs = json("me@home/a@b.toml 'me@home/a@b.toml@title=\"x@y\",trace.budget=1'")["inputs"];
    EXPECT_EQ(inputs[0]["name"], "me@home/a@b.toml");
    EXPECT_GT(inputs[0]["rays_per_pixel"], 1.0);
    EXPECT_EQ(inputs[1]["name"], "me@home/a@b.toml@title=\"x@y\",trace.budget=1");
    EXPECT_EQ(inputs[1]["rays_per_pixel"], 1.0);
}

TEST_F(BenchCommand, Tables_NameInputsControlAndClock)
{
    const auto outcome = bench("ball.toml ball.toml@trace.form=loop");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "") << "a pipe hears no progress";
    for (const char* text :
         {"24x24, 1 spp", "clock: ", "3 frames of each", "\nball.toml  ", "ball.toml@trace.form=loop",
          "ball.toml, again", "control", "rays a pixel", "1 cold start", "peak MiB"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text << " not in\n" << outcome.out;
}

TEST_F(BenchCommand, PlainShaders_AreTimedBesideScenes)
{
    const auto figures = json("ball.toml founding founding@u_radius=0.5");
    ASSERT_EQ(figures["inputs"].size(), 3U);
    EXPECT_EQ(figures["inputs"][2]["name"], "founding@u_radius=0.5");
    EXPECT_EQ(figures["inputs"][1]["rounds"]["frame_ms"].size(), 3U);
    EXPECT_EQ(figures["inputs"][1]["rays_per_pixel"], 0.0) << "nobody knows of a plain shader";
}

TEST_F(BenchCommand, OsMesa_IsNamedWhereItRan)
{
    EXPECT_EQ(json("ball.toml --backend osmesa")["backend"], "osmesa");
}

// A tracer of known speed stands in: 4 pixels in half a second are 0.5 * 576 / 4 seconds a picture.
TEST_F(BenchCommand, Python_IsScaledToTheWholePicture)
{
    ASSERT_EQ(
        here("mkdir -p host/command && cp -r \"$SOURCES/glsl\" glsl && ln -s \"$SOURCES/textures\" .").code,
        0);
    std::ofstream(folder / "host" / "command" / "plain_tracer.py") << R"(import json, sys
scene, width, height, stride = sys.argv[1], *map(int, sys.argv[2:])
assert scene == "ball.toml" and (width, height) == (24, 24) and stride >= 1
print(json.dumps({"pixels": 4, "seconds": 0.5, "scaled_seconds": 0.5 * width * height / 4}))
)";
    const auto outcome =
        here("export DIOPTRE_GLSL=$PWD/glsl && dioptre bench --size 24x24 --frames 3 --cold 1 --spp 2 "
             "ball.toml@trace.budget=1 --python --json");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto figures = nlohmann::json::parse(outcome.out);
    const double first_ms = figures["inputs"][0]["frame_ms"]["median"];
    EXPECT_EQ(figures["python"]["name"], "plain Python on ball");
    EXPECT_EQ(figures["python"]["scaled_from_pixels"], 4);
    EXPECT_DOUBLE_EQ(figures["python"]["frame_ms"], 2.0 * 72000.0); // two samples a pixel
    EXPECT_DOUBLE_EQ(figures["python"]["ratio"], 2.0 * 72000.0 / first_ms);
}

TEST_F(BenchCommand, Samples_AreForTheScenesBesideAPlainShader)
{
    std::ofstream(folder / "p.frag") << "void mainImage(out vec4 o, in vec2 p)\n{\n    o = vec4(1.0);\n}\n";
    const auto mixed = json("p.frag ball.toml --spp 2");
    EXPECT_EQ(mixed["samples"], 2);
    EXPECT_GE(mixed["inputs"][1]["rays_per_pixel"], 2.0); // the eye's ray of each sample
    EXPECT_NE(here("dioptre bench --help").out.find("plain shaders"), std::string::npos);
}
