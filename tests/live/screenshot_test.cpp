// What a screenshot of another size is told: all that the window shows otherwise than the file says.
#include "live/screenshot.h"

#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace dioptre::test
{
namespace
{

using Words = std::vector<std::string>;

Loaded plainLoaded()
{
    Loaded loaded;
    loaded.plain.emplace();
    loaded.sliders = {{"u_size", {1.0}},
                      {"u_tint", {0.0, 0.0, 0.0}},
                      {"u_light_type", {1.0}},
                      {"u_camera_position", {0.0, 1.6, 5.0}}};
    return loaded;
}

const Words allRead{"u_size", "u_tint", "u_light_type", "u_camera_position"};

bool holds(const Words& words, const std::string& word)
{
    return std::ranges::find(words, word) != words.end();
}

class Screenshot : public InAFolder
{
};

} // namespace

TEST_F(Screenshot, Name_IsTheFirstNumberThatIsFree)
{
    const auto pattern = folder / "a.b.png";
    EXPECT_EQ(freeName(pattern), folder / "a.b-1.png");
    std::ofstream(folder / "a.b-1.png") << "";
    std::ofstream(folder / "a.b-3.png") << "";
    EXPECT_EQ(freeName(pattern), folder / "a.b-2.png");
}

// Whoever writes it is told, and not the one that looks for a name.
TEST_F(Screenshot, NameInAFolderThatCannotBeLookedAt_IsTheFirst)
{
    std::ofstream(folder / "file") << "";
    EXPECT_EQ(freeName(folder / "file" / "a.png"), folder / "file" / "a-1.png");
    const std::string endless(300, 'x');
    EXPECT_NO_THROW(freeName(folder / (endless + ".png")));
}

TEST_F(Screenshot, NothingMoved_NothingTold)
{
    EXPECT_TRUE(valuesShown(LiveModel(LiveOptions{}), plainLoaded(), allRead).empty());
}

TEST_F(Screenshot, OfAPlainShader_TellsSlidersKeysAndMouse)
{
    LiveModel model(LiveOptions{});
    model.frame.live.sliders = {{"u_size", {2.5}}, {"u_tint", {0.25, 0.5, 1.0}}, {"u_gone", {3.0}}};
    model.frame.live.lightType = LightType::lightsOnly;
    model.frame.live.camera = Camera{};
    model.frame.live.camera->eye = {1.0, 2.0, 3.0};
    const Words told = valuesShown(model, plainLoaded(), allRead);
    EXPECT_EQ(told, (Words{"u_camera_position=[1, 2, 3]", "u_light_type=2", "u_size=2.5",
                           "u_tint=[0.25, 0.5, 1]"}));
}

// --set refuses them, and the picture has none of them.
TEST_F(Screenshot, OfUniformsThatAreOnlyDeclared_TellsNothing)
{
    LiveModel model(LiveOptions{});
    model.frame.live.sliders = {{"u_size", {2.5}}};
    model.frame.live.camera = Camera{};
    model.frame.live.camera->eye = {1.0, 2.0, 3.0};
    EXPECT_EQ(valuesShown(model, plainLoaded(), {"u_size"}), Words{"u_size=2.5"});
}

TEST_F(Screenshot, OfARadiancePicture_IsEncodedAsInTheWindow)
{
    LiveModel model(LiveOptions{});
    model.look.values["u_encode"] = "true";
    EXPECT_TRUE(holds(valuesShown(model, plainLoaded(), allRead), "u_encode=true"));
}

TEST_F(Screenshot, Words_AreTheCommandLinesOwn)
{
    LiveModel model(LiveOptions{});
    model.clock = LiveClock(1.5, true);
    model.look.input.path = "a.frag";
    model.look.places.included = {"here"};
    model.look.channels[2] = "b.png?filter=nearest";
    model.given = {"u_size=4"};
    const Words words = renderWords(model, plainLoaded(), allRead, "320x200", "out-1.png");
    EXPECT_EQ(words, (Words{"render", "a.frag", "-o", "out-1.png", "--size", "320x200", "--time", "1.5",
                            "--set", "u_size=4", "--include", "here", "--channel2", "b.png?filter=nearest"}));
}

} // namespace dioptre::test
