// Scenes latched one on the other: a number that has been through its range never changes the shader again.
#include "render/assemble.h"
#include "render/latch.h"
#include "render/pack.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace dioptre;

namespace
{

const std::filesystem::path latchGlsl = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";

// A scene under edits, each latched on the one before.
class Edited
{
public:
    Edited(std::string toml, std::vector<std::string> always = {})
        : toml_(std::move(toml)), always_(std::move(always)), scene_(parsed({})), text_(textOf(scene_))
    {
    }

    void go(const std::vector<std::string>& overrides)
    {
        Scene next = parsed(overrides);
        latch(next, scene_);
        scene_ = std::move(next);
    }

    // Whether the shader's text is another than after the last such edit.
    bool edit(const std::vector<std::string>& overrides)
    {
        go(overrides);
        const std::string text = textOf(scene_);
        const bool changed = text != text_;
        text_ = text;
        return changed;
    }

    Scene parsed(const std::vector<std::string>& overrides) const
    {
        auto all = always_;
        all.insert(all.end(), overrides.begin(), overrides.end());
        return parseScene(toml_, latchGlsl / "scenes" / "text.toml", all, 0.0, {{}, latchGlsl});
    }

    const Scene& scene() const
    {
        return scene_;
    }

    std::string textOf(const Scene& loaded)
    {
        const Scene scene = underLightType(loaded);
        const Plan plan = makePlan(scene);
        PackedScene packed = pack(scene, plan, {36, 1});
        // Of a picture, the text knows its size alone.
        const Picture picture{64, 64, PixelFormat::srgb8, {}, {}};
        packed.pictures.resize(plan.pictures.size(), {picture});
        return flatten(assemble(scene, plan, packed, latchGlsl)) +
               flatten(assembleVertex(plan, packed, latchGlsl));
    }

private:
    std::string toml_;
    std::vector<std::string> always_;
    Scene scene_;
    std::string text_;
};

// A number or a vector of a scene that a slider may move, and where: the path of --set, the range, and how
// many numbers it is.
struct Slider {
    std::string path;
    double low = 0.0;
    double high = 1.0;
    int components = 1;
    bool whole = false;
};

std::string valueAt(const Slider& slider, const std::vector<double>& numbers)
{
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : ", ") +
                (slider.whole ? std::to_string(std::lround(number)) : std::to_string(number));
    return slider.path + "=" + (numbers.size() > 1 ? "[" + text + "]" : text);
}

std::vector<Slider> slidersOf(const Scene& scene)
{
    std::vector<Slider> sliders = {{"camera.fov_y_deg", 5, 120},     {"trace.cut_off", 0, 0.1},
                                   {"trace.budget", 1, 40, 1, true}, {"trace.depth", 0, 9, 1, true},
                                   {"sky.exposure", -3, 3},          {"sky.rotation_deg", -180, 180}};
    for (const char* axis : {"eye", "target"}) {
        const auto& middle = std::string(axis) == "eye" ? scene.camera.eye : scene.camera.target;
        for (int i = 0; i < 3; ++i)
            sliders.push_back(
                {std::string("camera.") + axis + "." + std::to_string(i), middle[i] - 0.3, middle[i] + 0.3});
    }
    if (scene.sky.kind == Sky::Kind::colour)
        sliders.push_back({"sky.colour", 0, 2, 3});
    for (const auto& material : scene.materials) {
        const std::string section = "material." + material.name + ".";
        for (const char* share : {"mirror", "transmit"})
            sliders.push_back({section + share, 0, 1});
        for (const char* colour :
             {"colour", "ambient", "specular", "mirror_colour", "absorption", "emission"})
            sliders.push_back({section + colour, 0, 1, 3});
        sliders.push_back({section + "ior", 0.5, 2.5});
        sliders.push_back({section + "shininess", 0, 100});
        sliders.push_back({section + "size", 0.5, 2});
        sliders.push_back({section + "colours.0", 0, 1, 3});
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string section = "light." + std::to_string(i) + ".";
        for (const char* colour : {"ambient", "diffuse", "specular", "attenuation"})
            sliders.push_back({section + colour, 0, 1, 3});
        sliders.push_back({section + "cutoff_deg", 0, 90});
        sliders.push_back({section + "exponent", 0, 9});
        sliders.push_back({section + "position.1", 1, 5});
    }
    return sliders;
}

// Its ends, which hold 0 and 1 where those matter, and values between; those that the scene takes.
std::vector<std::string> valuesOf(const Slider& slider, const Edited& edited, std::mt19937& random)
{
    const auto count = static_cast<std::size_t>(slider.components);
    std::uniform_real_distribution<double> between(slider.low, slider.high);
    std::vector<double> mixed(count);
    std::ranges::generate(mixed, [&] { return between(random); });
    std::vector<std::string> values;
    for (const auto& numbers :
         {std::vector<double>(count, slider.low), mixed, std::vector<double>(count, slider.high)}) {
        try {
            const auto value = valueAt(slider, numbers);
            edited.parsed({value});
            values.push_back(value);
        } catch (const Error&) { // not of this kind of light, or a light without light
        }
    }
    return values;
}

// Each value through its range, all others as in the file; then many at once.
void expectToSettle(const std::filesystem::path& path, const std::vector<std::string>& always)
{
    const Scene scene = loadScene(path, always, 0.0, {{}, latchGlsl});
    Edited edited(readSceneText(path), always);
    std::mt19937 random(7);
    std::vector<std::vector<std::string>> ranges;
    for (const auto& slider : slidersOf(scene)) {
        ranges.push_back(valuesOf(slider, edited, random));
        for (const auto& value : ranges.back())
            edited.go({value});
    }
    std::erase_if(ranges, [](const auto& values) { return values.empty(); });
    EXPECT_GT(ranges.size(), 10U);
    edited.edit({});
    for (int round = 0; round < 12; ++round) {
        std::vector<std::string> values;
        for (const auto& range : ranges)
            if (random() % 2 == 0)
                values.push_back(range[random() % range.size()]);
        EXPECT_FALSE(edited.edit(values)) << path << ": " << testing::PrintToString(values);
    }
}

class Latched : public testing::TestWithParam<std::filesystem::path>
{
};

std::vector<std::filesystem::path> gallery()
{
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(latchGlsl / "scenes"))
        if (entry.path().extension() == ".toml")
            scenes.push_back(entry.path());
    std::ranges::sort(scenes);
    return scenes;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Latched, testing::ValuesIn(gallery()),
                         [](const auto& info) { return info.param.stem().string(); });

const std::string room = "[camera]\neye = [0, 1, 5]\n[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n"
                         "[material.m]\n[material.n]\noutside = \"m\"\n[[sphere]]\nname = \"ball\"\n"
                         "centre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n[[sphere]]\ncentre = [3, 0, 0]\n"
                         "radius = 1\nmaterial = \"n\"\n";

} // namespace

TEST_P(Latched, ValuesThatWentThroughTheirRangeOnce_NeverChangeTheTextAgain)
{
    expectToSettle(GetParam(), {"animate=[]"});
    if (!loadScene(GetParam(), {}, 0.0, {{}, latchGlsl}).animated.empty())
        expectToSettle(GetParam(), {});
}

// Queues and stacks have a size, and tables hold what selects choose from.
TEST(Latch, OtherFormsAndOrders_SettleToo)
{
    for (const char* choice : {"trace.form=loop", "trace.order=depth-first", "trace.order=breadth-first",
                               "plan.force=all", "trace.light_type=0", "trace.light_type=2"})
        expectToSettle(latchGlsl / "scenes" / "glass.toml", {"animate=[]", choice});
}

TEST(Latch, FeatureThatAnEditBringsIn_ChangesTheTextOnce)
{
    for (const char* value : {"material.m.mirror=0.5", "material.m.transmit=0.5",
                              "material.m.emission=[0,1,0]", "material.m.specular=[0,1,0]",
                              "material.n.ambient=[0,1,0]", "light.0.ambient=[0,0,1]", "trace.depth=3"}) {
        // With something to be limited and something of each light.
        const bool deep = std::string(value) == "trace.depth=3";
        const bool ambient = std::string(value).starts_with("material.n.ambient");
        Edited edited(room, {"material.m.model=blinn", deep ? "material.n.mirror=0.5" : "title=t",
                             ambient ? "light.0.ambient=[1,1,1]" : "title=t"});
        EXPECT_TRUE(edited.edit({value})) << value;
        EXPECT_FALSE(edited.edit({})) << value;
        EXPECT_FALSE(edited.edit({value})) << value;
    }
}

TEST(Latch, ShareThatLeavesOne_ChangesTheTextOnce)
{
    Edited edited(room, {"material.n.mirror=1"});
    EXPECT_TRUE(edited.edit({"material.m.mirror=1"}));
    EXPECT_FALSE(edited.edit({})) << "a surface that shows light shows it still";
    Edited mirrors(room, {"material.n.mirror=1", "material.m.mirror=1"});
    EXPECT_TRUE(mirrors.edit({"material.m.mirror=0.5"}));
    EXPECT_FALSE(mirrors.edit({}));
}

TEST(Latch, FeaturesOfSeveralEdits_Gather)
{
    Edited edited(room);
    EXPECT_TRUE(edited.edit({"material.m.mirror=0.5"}));
    EXPECT_TRUE(edited.edit({"material.n.transmit=0.5"}));
    EXPECT_FALSE(edited.edit({"material.m.mirror=0.7", "material.n.transmit=0.1"}));
    EXPECT_FALSE(edited.edit({}));
}

TEST(Latch, FirstEditWithinThePlan_LeavesTheTextOfTheSceneAsItWasLoaded)
{
    Edited edited(room, {"material.m.mirror=0.3"});
    EXPECT_FALSE(
        edited.edit({"material.m.mirror=0.9", "material.m.colour=[0.1,0.2,0.3]", "camera.eye=[1,2,6]"}));
}

TEST(Latch, ThousandsOfEdits_ForgetNothing)
{
    Edited edited(room);
    edited.edit({"material.m.emission=[1e-300,0,0]", "material.m.mirror=0.999999999999999889"});
    const Scene still = edited.parsed({});
    Scene last = edited.scene();
    for (int i = 0; i < 3000; ++i) {
        Scene next = still;
        latch(next, last);
        last = std::move(next);
    }
    EXPECT_EQ(edited.textOf(last), edited.textOf(edited.scene()));
}

TEST(Latch, BudgetOfTheTextGrowsAlone_ThePicturesIsTheScenesOwn)
{
    const std::vector<std::string> queue = {"trace.order=breadth-first", "material.m.mirror=0.5"};
    Edited edited(room, queue);
    EXPECT_FALSE(edited.edit({"trace.budget=4"}));
    EXPECT_TRUE(edited.edit({"trace.budget=40"}));
    EXPECT_FALSE(edited.edit({"trace.budget=1"}));
    const Plan plan = makePlan(edited.scene());
    EXPECT_EQ(plan.budget, 40);
    EXPECT_EQ(pack(edited.scene(), plan, {36, 1}).budget, 1);
    edited.edit({});
    EXPECT_EQ(pack(edited.scene(), makePlan(edited.scene()), {36, 1}).budget, 16);
}

TEST(Latch, MediaThatNoLongerNest_TakeTheirOwnBudget)
{
    Edited edited(room);
    edited.edit({"material.m.transmit=1", "material.n.transmit=1"});
    EXPECT_EQ(pack(edited.scene(), makePlan(edited.scene()), {36, 1}).budget, 24);
    edited.edit({"material.m.transmit=1"});
    EXPECT_EQ(makePlan(edited.scene()).budget, 24);
    EXPECT_EQ(pack(edited.scene(), makePlan(edited.scene()), {36, 1}).budget, 16);
}

TEST(Latch, EyeThatEntersAnOpaqueSolid_ChangesTheTextOnce)
{
    Edited edited(room);
    EXPECT_FALSE(edited.edit({"camera.eye=[0,2,5]"}));
    EXPECT_TRUE(edited.edit({"camera.eye=[0,0.5,0]"}));
    EXPECT_FALSE(edited.edit({}));
    EXPECT_FALSE(edited.edit({"camera.eye=[3,0.5,0]"})) << "another one";
}

TEST(Latch, CameraNearTheOrigin_KeepsIt_AndOneFarAway_MovesIt)
{
    // It looks 5 m across: the grid is of 64 m.
    Edited edited(room, {"camera.target=[0,1,0]"});
    EXPECT_FALSE(edited.edit({"camera.eye=[120,1,5]", "camera.target=[120,1,0]"}));
    EXPECT_EQ(sceneOrigin(typicalOf(edited.scene())), glm::dvec3(0.0));
    EXPECT_TRUE(edited.edit({"camera.eye=[130,1,5]", "camera.target=[130,1,0]"}));
    EXPECT_EQ(sceneOrigin(typicalOf(edited.scene())), glm::dvec3(128.0, 0.0, 0.0));
    EXPECT_FALSE(edited.edit({})) << "the way back is as long";
}

TEST(Latch, OtherStructure_IsLeftAsItWasLoaded)
{
    const Edited edited(room);
    for (const char* change :
         {"trace.light_type=2", "trace.form=loop", "plan.within=always", "camera.inside=m",
          "sky.gradient=[[0,0,0],[1,1,1],[0,0,0]]", "material.m.model=blinn", "material.m.shadow=none",
          "material.n.outside=n2", "ball.material=n"}) {
        const std::string wanted = change;
        const std::string extra = wanted.ends_with("n2") ? "[material.n2]\n" : "";
        const auto path = latchGlsl / "scenes" / "text.toml";
        Scene scene = parseScene(extra + room, path, {wanted}, 0.0, {{}, latchGlsl});
        latch(scene, edited.scene());
        EXPECT_TRUE(scene.typical.empty()) << change;
    }
    Scene lit = edited.parsed({"light=[]"});
    latch(lit, edited.scene());
    EXPECT_TRUE(lit.typical.empty());
}

TEST(Latch, AnimatedScene_KeepsWhatItsKeysAndEarlierEditsNeed)
{
    const std::string toml = room +
                             "[[animate]]\npath = \"material.m.mirror\"\ntimes = [0, 1]\nvalues = [0, 1]\n"
                             "[[animate]]\npath = \"ball.centre.1\"\ntimes = [0, 1]\nvalues = [0, 1]\n";
    Edited edited(toml);
    EXPECT_FALSE(edited.edit({}));
    EXPECT_TRUE(edited.edit({"material.n.transmit=0.5"}));
    EXPECT_FALSE(edited.edit({}));
    const Plan plan = makePlan(edited.scene());
    EXPECT_TRUE(plan.has("mirror"));
    EXPECT_TRUE(plan.has("refraction"));
    EXPECT_TRUE(plan.has("moving geometry"));
}
