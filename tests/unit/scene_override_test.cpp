// --set path=value, in every form of path and with every fault.
#include "scene/load.h"
#include "scene/override.h"

#include <gtest/gtest.h>

#include <ostream>

namespace dioptre
{

namespace
{

const char* const base = R"(title = "base"
[sky]
colour = [0.1, 0.2, 0.3]
[material.glass]
transmit = 1
[[light]]
kind = "point"
position = [1, 2, 3]
[[sphere]]
name = "ball"
centre = [0, 0, 0]
radius = 1
material = "glass"
[[sphere]]
name = "ball.small"
centre = [0, 0, 0]
radius = 0.5
)";

Scene with(const std::vector<std::string>& overrides)
{
    return parseScene(base, "base.toml", overrides);
}

TEST(Override, PathThroughTables_SetsTheValue)
{
    EXPECT_EQ(with({"material.glass.ior=1.5"}).materials[0].ior, 1.5);
    EXPECT_EQ(with({"title=\"other\""}).title, "other");
}

TEST(Override, MissingSections_AreCreated)
{
    const Scene scene = with({"trace.budget=4", "camera.fov_y_deg=30"});
    EXPECT_EQ(scene.trace.budget, 4);
    EXPECT_EQ(scene.camera.fovY_deg, 30.0);
    EXPECT_EQ(parseScene("", "a.toml", {"sky.colour=[1, 1, 1]"}).sky.colour, glm::dvec3(1.0));
}

TEST(Override, BareWord_IsAString)
{
    EXPECT_EQ(with({"trace.form=loop"}).trace.form, SceneForm::loop);
    EXPECT_EQ(with({"material.glass.colour=#ff0000"}).materials[0].colour, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(with({"title=a = b"}).title, "a = b");
}

TEST(Override, Numbers_PickElementsOfArrays)
{
    const Scene scene = with({"light.0.diffuse=[3, 2, 1]", "sphere.1.radius=7", "sky.colour.2=9"});
    EXPECT_EQ(scene.lights[0].diffuse, glm::dvec3(3.0, 2.0, 1.0));
    EXPECT_EQ(std::get<Sphere>(scene.objects[1].primitive).radius, 7.0);
    EXPECT_EQ(scene.sky.colour, glm::dvec3(0.1, 0.2, 9.0));
}

TEST(Override, ObjectsName_LeadsToTheObject)
{
    const Scene scene = with({"ball.centre=[1, 1, 1]", "ball.small.radius=0.25", "ball.centre.0=5"});
    EXPECT_EQ(std::get<Sphere>(scene.objects[0].primitive).centre, glm::dvec3(5.0, 1.0, 1.0));
    EXPECT_EQ(std::get<Sphere>(scene.objects[1].primitive).radius, 0.25);
}

TEST(Override, LaterOne_Wins)
{
    EXPECT_EQ(with({"trace.budget=4", "trace.budget=9"}).trace.budget, 9);
}

TEST(Override, NewKindOfSky_ReplacesTheOld)
{
    const Scene scene = with({"sky.gradient=[[0, 0, 0], [1, 1, 1], [2, 2, 2]]", "sky.exposure=1"});
    EXPECT_EQ(scene.sky.kind, Sky::Kind::gradient);
    EXPECT_EQ(scene.sky.exposure, 1.0);
    const char* pictured = "[sky]\nimage = \"/nonexistent.hdr\"\nrotation_deg = 30\n";
    EXPECT_EQ(parseScene(pictured, "a.toml", {"sky.colour=#ffffff"}).sky.colour, glm::dvec3(1.0));
}

TEST(Override, EmptyArray_RemovesObjects)
{
    EXPECT_TRUE(with({"sphere=[]"}).objects.empty());
}

struct BadOverride {
    const char* name;
    const char* text;
    ExitCode code;
    const char* fragment;
};

void PrintTo(const BadOverride& row, std::ostream* out)
{
    *out << row.text;
}

const BadOverride badOverrides[] = {
    {"NoEqualsSign", "trace.form", ExitCode::usage, "write path=value"},
    {"NoPath", "=3", ExitCode::usage, "write path=value"},
    {"UnknownKey", "trace.frm=loop", ExitCode::badInput, "did you mean 'form'?"},
    {"UnknownWord", "trace.form=lop", ExitCode::badInput, "did you mean 'loop'?"},
    {"WrongType", "ball.radius=big", ExitCode::badInput,
     "radius is the string \"big\": give a number above 0"},
    {"BrokenArray", "camera.eye=[1, 2", ExitCode::badInput, "the string \"[1, 2\""},
    {"OutOfRange", "ball.radius=-1", ExitCode::badInput, "above 0"},
    {"OneBadElement", "sky.colour.1=nan", ExitCode::badInput, "colour[1] is the number nan"},
    {"PictureMissing", "sky.image=no/sky.hdr", ExitCode::inputMissing, "no such file"},
    {"UnknownSection", "trce.form=loop", ExitCode::usage, "the scene has no 'trce': did you mean 'trace'?"},
    {"UnknownObject", "bal.radius=2", ExitCode::usage, "did you mean 'ball'?"},
    {"ObjectWithoutKey", "ball=2", ExitCode::usage, "the scene has no 'ball'"},
    {"UnknownMaterial", "material.glas.ior=2", ExitCode::usage, "did you mean 'glass'?"},
    {"NoMaterialMeant", "material.zzzzzzzzz.ior=2", ExitCode::usage, "it has glass"},
    {"IndexTooLarge", "sphere.2.radius=2", ExitCode::usage, "count from 0 to 1"},
    {"IndexNegative", "sphere.-1.radius=2", ExitCode::usage, "'-1' is no element"},
    {"IndexNoNumber", "sphere.x.radius=2", ExitCode::usage, "'x' is no element of an array of 2"},
    {"PastTheEnd", "ball.radius.x=2", ExitCode::usage, "leads into the number 1"},
    {"KindThatIsAbsent", "plane.0.normal=[0, 1, 0]", ExitCode::usage, "there is no 'plane'"},
    {"TableAsValue", "camera={eye = [1, 1, 1]}", ExitCode::usage, "set its keys one by one"},
    {"EmptyStep", "trace.=3", ExitCode::badInput, "has no key ''"},
    {"SecondLine", "ball.radius=1\nb = 2", ExitCode::badInput, "the string"},
};

class OverrideRefusal : public testing::TestWithParam<BadOverride>
{
};

TEST_P(OverrideRefusal, StandsUnderItsOwnText)
{
    const BadOverride& bad = GetParam();
    try {
        with({bad.text});
        FAIL() << "was accepted";
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("--set " + std::string(bad.text) + ": ")) << message;
        EXPECT_NE(message.find(bad.fragment), std::string::npos) << message << "\nlacks " << bad.fragment;
        EXPECT_EQ(error.code(), bad.code) << message;
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, OverrideRefusal, testing::ValuesIn(badOverrides),
                         [](const auto& row) { return std::string(row.param.name); });

using Parts = std::vector<std::string>;

TEST(Overrides_Split, AtCommas)
{
    EXPECT_EQ(splitOverrides("trace.form=loop"), (Parts{"trace.form=loop"}));
    EXPECT_EQ(splitOverrides("trace.form=loop,trace.budget=4"), (Parts{"trace.form=loop", "trace.budget=4"}));
}

TEST(Overrides_Split, NotWithinBracketsOrQuotes)
{
    EXPECT_EQ(splitOverrides("light.0.diffuse=[1,0,0],trace.budget=4"),
              (Parts{"light.0.diffuse=[1,0,0]", "trace.budget=4"}));
    EXPECT_EQ(splitOverrides("sky.gradient=[[1,0,0],[0,1,0],[0,0,1]],trace.budget=4"),
              (Parts{"sky.gradient=[[1,0,0],[0,1,0],[0,0,1]]", "trace.budget=4"}));
    EXPECT_EQ(splitOverrides("title=\"one, two\",trace.budget=4"),
              (Parts{"title=\"one, two\"", "trace.budget=4"}));
    EXPECT_EQ(splitOverrides("title='a [,b',trace.budget=4"), (Parts{"title='a [,b'", "trace.budget=4"}));
}

TEST(Overrides_Split, AnApostropheInAName_OpensNothing)
{
    EXPECT_EQ(splitOverrides("Ann's ball.radius=1,trace.budget=4"),
              (Parts{"Ann's ball.radius=1", "trace.budget=4"}));
}

// Faults stay what they are, for applyOverrides to name.
TEST(Overrides_Split, EmptyParts_Remain)
{
    EXPECT_EQ(splitOverrides("a=1,,b=2"), (Parts{"a=1", "", "b=2"}));
    EXPECT_EQ(splitOverrides("a=1,"), (Parts{"a=1", ""}));
}

} // namespace

} // namespace dioptre
