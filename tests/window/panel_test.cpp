// The panel under a user's pointer, and what a window remembers.
#include "base/file.h"
#include "support/in_a_window.h"

#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

const std::string slider = "uniform float u_share; // 0.25 [0, 1] the picture's red\nvoid mainImage(out vec4 "
                           "c, in vec2 p) { c = vec4(u_share, 0.0, 0.5, 1.0); }\n";

class Panel : public InAWindow
{
protected:
    Panel()
    {
        usualWords = {"--forget"};
        save(folder / "a.toml", oneBall);
        save(folder / "a.frag", slider);
    }

    // Where the panel is not.
    static constexpr int wide = 640, high = 480;
    Rgb beside() const
    {
        return at({wide - 10, 10});
    }
};

class Memory : public InAWindow
{
protected:
    Memory()
    {
        usualWords = {};
        save(folder / "a.toml", oneBall);
    }
    void leave()
    {
        hand->tap("q", {"Control_L"});
        EXPECT_EQ(program->ended(), 0) << program->error();
    }
};

} // namespace

// Row after row from below, until one of them is the slider's: the heading above it would fold it away.
TEST_F(Panel, SliderUnderADrag_FeedsItsUniform_AndIsWrittenBack)
{
    open({"a.frag", "--size", "640x480"});
    ASSERT_TRUE(eventually([&] { return beside() == Rgb{64, 0, 128}; })) << beside().red;
    for (int y = 160; y > 80 && beside().red == 64; y -= 5) {
        hand->drag({150, y}, {240, y}, 1, 4);
        eventually([&] { return beside().red != 64; }, 0.15);
    }
    const Picture moved = settled();
    const int red = pixelOf(moved, wide - 10, 10).red;
    EXPECT_NE(red, 64);
    EXPECT_EQ(readFile(folder / "a.frag"), slider);
    hand->moveTo(wide - 10, high - 10);
    hand->tap("s", {"Control_L"});
    program->next("written");
    const std::string text = readFile(folder / "a.frag");
    EXPECT_EQ(std::lround(255.0 * std::stod(text.substr(text.find("// ") + 3))), red) << text;
    EXPECT_EQ(text.substr(text.find(" [0, 1]")), slider.substr(slider.find(" [0, 1]")));
}

// The wheel is the panel's while it lies under the pointer, and the camera's once it is hidden there.
TEST_F(Panel, HiddenUnderThePointer_LeavesTheWheelToTheCamera)
{
    open({"a.toml", "--spp", "1", "--size", "640x480"});
    hand->moveTo(60, 60);
    program->next("done");
    settled();
    const Rgb first = beside();
    const auto cornerChanges = [&](double limit_s) {
        return eventually([&] { return !(beside() == first); }, limit_s);
    };
    hand->wheel(-8);
    EXPECT_FALSE(cornerChanges(1.0)) << "over the panel";
    hand->tap("Tab");
    settled();
    hand->wheel(-8);
    EXPECT_TRUE(cornerChanges(30.0)) << "over the picture";
}

TEST_F(Memory, SizePanelAndCamera_AreThereAgain_AndNothingInTheProject)
{
    open({"a.toml", "--spp", "1"});
    hand->resize(300, 200);
    hand->moveTo(290, 190);
    hand->tap("Tab");
    EXPECT_TRUE(eventually([&] { return hand->size() == std::pair(300, 200); }));
    const Picture before = settled();
    hand->wheel(2);
    EXPECT_TRUE(changesFrom(before));
    const Picture left = settled();
    leave();
    open({"a.toml", "--spp", "1"});
    EXPECT_TRUE(eventually([&] { return hand->see().bytes == left.bytes; })) << hand->size().first;
    hand->tap("F11");
    EXPECT_TRUE(eventually([&] { return hand->size() == std::pair(1280, 1024); })) << hand->size().first;
    leave();
    open({"a.toml", "--spp", "1"});
    EXPECT_TRUE(eventually([&] { return hand->see().bytes == left.bytes; })) << hand->size().first;
    EXPECT_EQ(readFile(folder / "a.toml"), oneBall);
    for (const auto& file : std::filesystem::directory_iterator(folder))
        EXPECT_TRUE(file.path().filename() == "a.toml" || file.path().filename() == "state" ||
                    file.path().filename() == "stderr")
            << file.path();

    open({"a.toml", "--spp", "1", "--forget"});
    EXPECT_TRUE(eventually([&] { return hand->size() == std::pair(1280, 720); })) << hand->size().first;
    leave();

    // Another camera in the file: what the hand left belongs to the one before.
    std::string edited = oneBall;
    edited.replace(edited.find("40.0"), 4, "55.0");
    save(folder / "a.toml", edited);
    open({"a.toml", "--spp", "1"});
    program->next("done");
    const Picture fresh = settled();
    EXPECT_EQ(std::pair(fresh.width, fresh.height), std::pair(300, 200));
    leave();
    open({"a.toml", "--spp", "1", "--forget", "--no-panel", "--size", "300x200"});
    program->next("done");
    EXPECT_EQ(settled().bytes, fresh.bytes);
}
