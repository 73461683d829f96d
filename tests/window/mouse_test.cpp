// The mouse moves the camera of a scene, and is a plain shader's iMouse.
#include "support/in_a_window.h"

#include <thread>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// iMouse.xy and the sign of z as the left half's colour, |z|, |w| and the sign of w as the right's.
const std::string mouseShader = R"(void mainImage(out vec4 c, in vec2 p)
{
    vec3 left = vec3(floor(iMouse.xy), iMouse.z > 0.0 ? 255.0 : 0.0);
    vec3 right = vec3(floor(abs(iMouse.zw)), iMouse.w > 0.0 ? 255.0 : 0.0);
    c = vec4((p.x < 100.0 ? left : right) / 255.0, 1.0);
}
)";

class Mouse : public InAWindow
{
protected:
    // The two halves' colours once they are so; otherwise what they are.
    std::pair<Rgb, Rgb> mouse(const Rgb& left, const Rgb& right) const
    {
        const auto seen = [&] { return std::pair(at({50, 80}), at({150, 80})); };
        eventually([&] { return seen() == std::pair(left, right); }, 5.0);
        return seen();
    }
    void expectMouse(const Rgb& left, const Rgb& right, const char* when) const
    {
        const auto [l, r] = mouse(left, right);
        EXPECT_EQ(std::tuple(l.red, l.green, l.blue), std::tuple(left.red, left.green, left.blue)) << when;
        EXPECT_EQ(std::tuple(r.red, r.green, r.blue), std::tuple(right.red, right.green, right.blue)) << when;
    }
};

} // namespace

TEST_F(Mouse, EveryGesture_MovesTheCamera_AndRBringsItBackBitForBit)
{
    save(folder / "a.toml", oneBall);
    open({"a.toml", "--spp", "1"});
    program->next("done");
    const Picture first = settled();
    const std::vector<std::pair<const char*, std::function<void()>>> gestures{
        {"wheel", [&] { hand->wheel(-2); }},
        {"drag",
         [&] {
             hand->drag({60, 80}, {110, 95});
         }},
        {"right drag",
         [&] {
             hand->drag({60, 80}, {110, 95}, 3);
         }},
        {"middle drag",
         [&] {
             hand->drag({60, 80}, {90, 95}, 2);
         }},
        {"shift drag",
         [&] {
             hand->press("Shift_L");
             hand->drag({60, 80}, {90, 95});
             hand->release("Shift_L");
         }},
    };
    std::vector<Picture> seen{first};
    for (const auto& [name, gesture] : gestures) {
        gesture();
        EXPECT_TRUE(changesFrom(first)) << name;
        seen.push_back(settled());
        hand->tap("r");
        EXPECT_TRUE(eventually([&] { return hand->see().bytes == first.bytes; })) << "R after " << name;
    }
    EXPECT_EQ(seen[4].bytes, seen[5].bytes) << "the middle button, and shift with the left";
    EXPECT_NE(seen[2].bytes, seen[3].bytes);
    for (const std::string key : {"w", "a", "s", "d", "q", "e"}) {
        hand->press(key);
        EXPECT_TRUE(changesFrom(first)) << key;
        hand->release(key);
        settled();
        hand->tap("r");
        EXPECT_TRUE(eventually([&] { return hand->see().bytes == first.bytes; })) << "R after " << key;
    }
}

// A full turn: a drag over the picture's height is half of one.
TEST_F(Mouse, Orbit_OfAFullTurn_EndsWhereItBegan)
{
    save(folder / "a.toml", oneBall);
    open({"a.toml", "--spp", "1", "--size", "500x160"});
    program->next("done");
    const Picture first = settled();
    hand->drag({100, 80}, {420, 80}, 1, 16);
    const Picture last = settled();
    std::size_t different = 0; // rounding moves an edge here and there
    for (std::size_t i = 0; i < first.bytes.size(); ++i)
        different += std::abs(first.bytes[i] - last.bytes[i]) > 2 ? 1U : 0U;
    EXPECT_LT(different, first.bytes.size() / 500);
}

// As Shadertoy has it: xy where the button is or was held, |zw| where it was pressed; z above 0 while it is
// held, w only in the first frame of a click.
TEST_F(Mouse, IMouse_FollowsADragAndTellsTheClick)
{
    save(folder / "a.frag", mouseShader);
    open({"a.frag"});
    hand->moveTo(20, 30);
    expectMouse({0, 0, 0}, {0, 0, 0}, "no button was pressed");
    hand->moveTo(60, 100); // 59 rows from below
    hand->pressButton();
    expectMouse({60, 59, 255}, {60, 59, 255}, "pressed: this picture is the click's frame");
    hand->moveTo(80, 60);
    expectMouse({80, 99, 255}, {60, 59, 0}, "dragged");
    hand->releaseButton();
    expectMouse({80, 99, 0}, {60, 59, 0}, "released");
    hand->moveTo(10, 10);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    expectMouse({80, 99, 0}, {60, 59, 0}, "moved without a button");
    hand->moveTo(120, 20);
    hand->pressButton();
    expectMouse({120, 139, 255}, {120, 139, 255}, "pressed again");
    hand->releaseButton();
    expectMouse({120, 139, 0}, {120, 139, 0}, "and released");
}
