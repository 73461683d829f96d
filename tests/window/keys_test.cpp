// Every key does what its table says, as seen in the window.
#include "base/file.h"
#include "support/in_a_window.h"

using namespace dioptre;
using namespace dioptre::test;

namespace
{

const std::string balls = R"(# A comment above.
[camera] # where one looks from
eye = [0.0, 1.0, 6.0]
target = [0.0, 0.0, 0.0]
fov_y_deg = 40.0
[sky]
gradient = [[0.1, 0.1, 0.2], [0.3, 0.3, 0.4], [0.2, 0.4, 0.8]]
[material.red]
colour = [0.8, 0.2, 0.1] # a comment beside
mirror = 0.3
[[light]]
kind = "ambient"
ambient = [0.3, 0.3, 0.3]
[[light]]
kind = "point"
position = [2.0, 1.5, 2.0]
diffuse = [0.7, 0.7, 0.7]
[[sphere]]
centre = [0.0, 0.0, 0.0]
radius = 1.0
material = "red"
[[sphere]]
centre = [1.0, -1.0, 1.0]
radius = 0.5
# The last comment.
)";

// The orders trace other five rays of a pixel.
const std::string glass = R"([camera]
eye = [0.0, 1.0, 6.0]
target = [0.0, 0.0, 0.0]
fov_y_deg = 40.0
[sky]
gradient = [[0.1, 0.1, 0.2], [0.3, 0.3, 0.4], [0.2, 0.4, 0.8]]
[trace]
budget = 5
order = "heaviest-first"
[material.glass]
transmit = 1.0
ior = 1.5
[[light]]
kind = "ambient"
ambient = [0.3, 0.3, 0.3]
[[sphere]]
centre = [0.0, 0.0, 0.0]
radius = 1.5
material = "glass"
[[sphere]]
centre = [0.5, 0.0, -2.0]
radius = 1.0
material = "glass"
)";

// Below the notices.
std::vector<std::uint8_t> lowerPart(const Picture& picture)
{
    const auto rows = static_cast<std::size_t>(picture.height) * 94 / 160;
    return {picture.bytes.begin(),
            picture.bytes.begin() +
                static_cast<std::ptrdiff_t>(4 * rows * static_cast<std::size_t>(picture.width))};
}

class Keys : public InAWindow
{
protected:
    // Opens the scene and gives its finished picture.
    Picture openBalls(std::vector<std::string> more = {})
    {
        save(folder / "a.toml", balls);
        more.insert(more.begin(), {"a.toml", "--spp", "2"});
        open(more);
        program->next("done");
        const Picture first = settled();
        EXPECT_NE(pixelOf(first, 100, 80), (Rgb{0, 0, 0}));
        return first;
    }
    bool lowerIs(const Picture& picture) const
    {
        return eventually([&] { return lowerPart(hand->see()) == lowerPart(picture); });
    }
    bool lowerChangesFrom(const Picture& picture) const
    {
        return eventually([&] { return lowerPart(hand->see()) != lowerPart(picture); });
    }
};

} // namespace

TEST_F(Keys, HelpPanelAndEscape_ComeAndGo)
{
    const Picture first = openBalls();
    const auto gone = [&] { return eventually([&] { return hand->see().bytes == first.bytes; }); };
    for (const std::string key : {"F1", "h"}) {
        hand->tap(key);
        EXPECT_TRUE(lowerChangesFrom(first)) << key;
        hand->tap(key);
        EXPECT_TRUE(gone()) << key;
    }
    hand->tap("F1");
    EXPECT_TRUE(lowerChangesFrom(first));
    hand->tap("Escape");
    EXPECT_TRUE(gone());
    hand->tap("Tab");
    EXPECT_TRUE(lowerChangesFrom(first));
    hand->tap("Tab");
    EXPECT_TRUE(gone());
    hand->tap("F11");
    EXPECT_TRUE(eventually([&] { return hand->size() == std::pair(1280, 1024); })) << hand->size().first;
    hand->tap("Escape");
    EXPECT_TRUE(eventually([&] { return hand->size() == std::pair(width, height); })) << hand->size().first;
    EXPECT_TRUE(gone());
}

TEST_F(Keys, WhatIsTraced_ChangesAndIsDroppedBitForBit)
{
    const Picture first = openBalls();
    for (const std::string key : {"l", "Prior", "Next"}) { // Page up, Page down
        hand->tap(key);
        program->next("shown");
        EXPECT_TRUE(lowerChangesFrom(first)) << key;
        hand->tap("z", {"Control_L"});
        program->next("shown");
        EXPECT_TRUE(lowerIs(first)) << "Ctrl+Z after " << key;
    }
    hand->tap("m");
    EXPECT_EQ(program->next("shown")["compiled"], true) << "another order";
    for (const std::string key : {"equal", "minus", "KP_Add", "KP_Subtract"}) {
        hand->tap(key);
        program->next("shown");
    }
    hand->tap("z", {"Control_L"});
    program->next("shown");
    EXPECT_TRUE(lowerIs(first));
    hand->tap("v");
    program->next("shown");
    EXPECT_TRUE(lowerChangesFrom(first)) << "a view";
}

TEST_F(Keys, Method_ComesRoundToTheFirstBitForBit)
{
    save(folder / "a.toml", glass);
    open({"a.toml", "--spp", "1"});
    program->next("done");
    const Picture heaviest = settled();
    hand->tap("m");
    program->next("shown");
    EXPECT_TRUE(lowerChangesFrom(heaviest));
    const Picture breadth = settled();
    hand->tap("m");
    program->next("shown");
    EXPECT_TRUE(lowerChangesFrom(breadth));
    EXPECT_NE(lowerPart(settled()), lowerPart(heaviest));
    hand->tap("m");
    program->next("shown");
    EXPECT_TRUE(lowerIs(heaviest));
}

TEST_F(Keys, Samples_AreDoubledAndHalved)
{
    openBalls();
    hand->tap("bracketright");
    EXPECT_EQ(program->next("done")["samples"], 4);
    hand->tap("bracketright");
    EXPECT_EQ(program->next("done")["samples"], 8);
    hand->tap("bracketleft");
    EXPECT_EQ(program->next("done")["samples"], 4);
}

TEST_F(Keys, CopiedCamera_IsWhatASceneTakes)
{
    openBalls();
    hand->wheel(3);
    program->next("done");
    const Picture seen = settled();
    hand->tap("c");
    std::string copied;
    ASSERT_TRUE(eventually([&] {
        try {
            copied = hand->clipboard();
        } catch (const std::runtime_error&) { // nobody owns it yet
        }
        return copied.starts_with("[camera]\n");
    })) << copied;
    EXPECT_EQ(copied.find("fov_y_deg = 40.0"), std::string::npos) << copied;
    save(folder / "b.toml", copied + balls.substr(balls.find("[sky]")));
    open({"b.toml", "--spp", "2"});
    program->next("done");
    EXPECT_EQ(settled().bytes, seen.bytes);
}

TEST_F(Keys, Screenshot_HoldsTheWindowsPixels)
{
    const Picture seen = openBalls({"-o", "shot.png"});
    for (const std::string key : {"p", "F12"}) {
        hand->tap(key);
        const auto file = program->next("screenshot")["file"].get<std::string>();
        EXPECT_EQ(file, key == "p" ? "shot-1.png" : "shot-2.png");
        const Picture shot = readPicture(folder / file);
        EXPECT_EQ(std::pair(shot.width, shot.height), std::pair(width, height));
        EXPECT_EQ(shot.bytes, seen.bytes) << key;
    }
}

TEST_F(Keys, ScreenshotOfAnotherSize_IsThatOfTheCommandLine)
{
    openBalls({"--screenshot", "320x200", "-o", "shot.png"});
    hand->tap("p");
    program->next("screenshot");
    ASSERT_EQ(here("dioptre render a.toml --size 320x200 --spp 2 -o still.png").code, 0);
    const Picture shot = readPicture(folder / "shot-1.png"), still = readPicture(folder / "still.png");
    EXPECT_EQ(std::pair(shot.width, shot.height), std::pair(320, 200));
    EXPECT_EQ(shot.bytes, still.bytes);
}

TEST_F(Keys, WritingBack_KeepsComments)
{
    const Picture first = openBalls();
    hand->tap("s", {"Control_L"});
    EXPECT_TRUE(changesFrom(first)) << "nothing was changed: a notice";
    EXPECT_EQ(readFile(folder / "a.toml"), balls);
    hand->tap("l");
    program->next("done");
    hand->wheel(2);
    program->next("done");
    const Picture changed = settled();
    hand->tap("s", {"Control_L"});
    EXPECT_EQ(program->next("written")["file"], "a.toml");
    program->next("shown");
    EXPECT_TRUE(lowerIs(changed));
    const std::string text = readFile(folder / "a.toml");
    for (const std::string part :
         {"# A comment above.\n[camera] # where one looks from\neye = [0.0, 1.0, 6.0]\n",
          "colour = [0.8, 0.2, 0.1] # a comment beside\n", "# The last comment.\n", "light_type = 2"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " not in\n" << text;
    EXPECT_EQ(text.find("fov_y_deg = 40.0"), std::string::npos) << text;
    EXPECT_FALSE(program->nextIfThere("error"));
}

// What the hand has written is not hidden by the words of the command line.
TEST_F(Keys, WritingBackOverASet_KeepsThePicture)
{
    openBalls({"--set", "camera.fov_y_deg=50", "--set", "trace.light_type=0"});
    hand->wheel(2);
    program->next("done");
    hand->tap("l");
    program->next("shown");
    program->next("done");
    const Picture changed = settled();
    hand->tap("s", {"Control_L"});
    program->next("written");
    program->next("shown");
    EXPECT_TRUE(lowerIs(changed));
    EXPECT_NE(readFile(folder / "a.toml").find("light_type = 1"), std::string::npos);
}

TEST_F(Keys, QuickPresses_AreCountedFromWhatWasAskedFor)
{
    openBalls();
    const auto budgetAfter = [&](int presses) {
        for (int i = 0; i < presses; ++i)
            hand->tap("equal");
        hand->tap("s", {"Control_L"});
        program->next("written");
        const std::string text = readFile(folder / "a.toml"), key = "budget = ";
        EXPECT_NE(text.find(key), std::string::npos) << text;
        return std::stoi(text.substr(text.find(key) + key.size()));
    };
    const int one = budgetAfter(1);
    EXPECT_EQ(budgetAfter(5), one + 5);
}

TEST_F(Keys, Budget_ChangesThePicture)
{
    const Picture first = openBalls({"--set", "trace.budget=1"});
    hand->tap("equal"); // a second ray: what the mirror shows
    program->next("shown");
    EXPECT_TRUE(lowerChangesFrom(first)) << "one ray more";
    const Picture more = settled();
    hand->tap("minus");
    program->next("shown");
    EXPECT_TRUE(lowerIs(first)) << "one ray less";
    EXPECT_NE(lowerPart(more), lowerPart(first));
}
