// Time under a user's keys, and over a reload.
#include "support/in_a_window.h"

#include <thread>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

using Time = InAWindow;

// Time in steps of a tenth of a second, as red.
std::string clockShader(int blue)
{
    return "void mainImage(out vec4 c, in vec2 p)\n{\n    c = vec4(mod(floor(iTime * 10.0 + 0.5), 256.0), "
           "0.0, " +
           std::to_string(blue) + ".0, 255.0) / 255.0;\n}\n";
}

} // namespace

TEST_F(Time, IsSteppedScrubbedAndHeld)
{
    save(folder / "a.frag", clockShader(0));
    open({"a.frag", "--paused", "--time", "5", "--fps", "10"});
    const auto shows = [&](int red) {
        return eventually([&] { return at(freePlace).red == red; }) ? red : at(freePlace).red;
    };
    EXPECT_EQ(shows(50), 50);
    hand->tap("period");
    EXPECT_EQ(shows(51), 51);
    hand->tap("comma");
    EXPECT_EQ(shows(50), 50);
    hand->tap("Right");
    EXPECT_EQ(shows(60), 60);
    hand->tap("Left");
    hand->tap("Left");
    EXPECT_EQ(shows(40), 40);
    hand->tap("Home");
    EXPECT_EQ(shows(50), 50);

    hand->tap("space");
    EXPECT_TRUE(eventually([&] { return at(freePlace).red > 52; })) << "it runs";
    hand->tap("space");
    const Picture held = settled();
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    EXPECT_EQ(hand->see().bytes, held.bytes) << "it stands";
}

TEST_F(Time, GoesOnOverAReload_UnlessItIsToBeginAnew)
{
    save(folder / "a.frag", clockShader(0));
    open({"a.frag", "--paused", "--time", "5"});
    for (int i = 0; i < 7; ++i)
        hand->tap("Right");
    EXPECT_TRUE(eventually([&] { return at(freePlace) == Rgb{120, 0, 0}; }));
    save(folder / "a.frag", clockShader(99));
    EXPECT_TRUE(eventually([&] { return at(freePlace) == Rgb{120, 0, 99}; })) << at(freePlace).red;
    hand->tap("t");
    save(folder / "a.frag", clockShader(77));
    EXPECT_TRUE(eventually([&] { return at(freePlace) == Rgb{50, 0, 77}; })) << at(freePlace).red;

    open({"a.frag", "--paused", "--restart", "--time", "1"});
    hand->tap("Right");
    EXPECT_TRUE(eventually([&] { return at(freePlace) == Rgb{20, 0, 77}; }));
    save(folder / "a.frag", clockShader(55));
    EXPECT_TRUE(eventually([&] { return at(freePlace) == Rgb{10, 0, 55}; })) << at(freePlace).red;
}

TEST_F(Time, Running_DoesNotJumpBackOverAReload_UnlessItIsToBeginAnew)
{
    for (const bool restarts : {false, true}) {
        save(folder / "a.frag", clockShader(0));
        open(restarts ? std::vector<std::string>{"a.frag", "--restart"} : std::vector<std::string>{"a.frag"});
        for (int i = 0; i < 10; ++i)
            hand->tap("Right");
        ASSERT_TRUE(eventually([&] { return at(freePlace).red > 105; }));
        save(folder / "a.frag", clockShader(99));
        ASSERT_TRUE(eventually([&] { return at(freePlace).blue == 99; }));
        const int after = at(freePlace).red;
        EXPECT_TRUE(restarts ? after < 100 : after > 105) << restarts << " " << after;
    }
}
