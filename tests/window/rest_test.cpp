// A window with nothing to do does nothing, and ends when it is to, with all that it started.
#include "support/in_a_window.h"

#include <csignal>
#include <thread>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

using namespace std::chrono_literals;

const std::string still = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n[sky]\ncolour = [0.2, 0.3, "
                          "0.4]\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";

// Of the window and its helper.
double cpuOfAll_s(const LiveProcess& program)
{
    double sum_s = cpuOf_s(program.id());
    for (const pid_t child : program.children())
        sum_s += cpuOf_s(child);
    return sum_s;
}

class Rest : public InAWindow
{
};

// By signal or by the window's own button.
class End : public InAWindow, public testing::WithParamInterface<int>
{
};
INSTANTIATE_TEST_SUITE_P(Signals, End, testing::Values(SIGINT, SIGTERM, SIGKILL),
                         [](const auto& info) { return std::string(::sigabbrev_np(info.param)); });

} // namespace

// Side by side, for the suite's time. Under 2 % of a core are 0.06 s of 3; the kernel counts in ticks of
// 0.01 s, of which an interval's ends may bring one each for either process.
TEST_F(Rest, FinishedPictures_TakeNoProcessor)
{
    save(folder / "a.toml", still);
    save(folder / "unused.frag", "uniform float u_time;\nvoid mainImage(out vec4 c, in vec2 p) { c = "
                                 "vec4(p.xy / iResolution.xy, 0.0, 1.0); }\n");
    save(folder / "paused.frag",
         "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(iTime), 0.0, 0.0, 1.0); }\n");
    const std::vector<std::vector<std::string>> cases{{"a.toml", "--spp", "4"},
                                                      {"unused.frag"},
                                                      {"paused.frag", "--paused"},
                                                      {"a.toml", "--spp", "4", "panel"}};
    std::vector<std::unique_ptr<LiveProcess>> programs;
    for (auto words : cases) {
        if (words.back() == "panel")
            words.pop_back();
        else
            words.push_back("--no-panel");
        words.insert(words.end(), {"--forget", "--size", "200x160"});
        programs.push_back(std::make_unique<LiveProcess>(folder, words, environment));
    }
    for (const auto& program : programs)
        program->next("done");
    std::this_thread::sleep_for(3s); // first the panel settles, and the lost weight is measured
    std::vector<double> before_s;
    for (const auto& program : programs)
        before_s.push_back(cpuOfAll_s(*program));
    std::this_thread::sleep_for(3s);
    for (std::size_t i = 0; i < programs.size(); ++i)
        EXPECT_LT(cpuOfAll_s(*programs[i]) - before_s[i], 0.06 + 0.04) << cases[i].front() << " " << i;
}

TEST_P(End, EndsTheWindowAndItsHelper)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    const auto children = program->children();
    ASSERT_EQ(children.size(), 1U);
    hand.reset();
    program->signal(GetParam());
    EXPECT_EQ(program->ended(), 128 + GetParam()) << program->error();
    EXPECT_TRUE(eventually([&] { return !isRunning(children.front()); }, 10.0));
}

TEST_F(Rest, CloseButton_EndsTheWindowAndItsHelper)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    const auto children = program->children();
    ASSERT_EQ(children.size(), 1U);
    hand->askToClose();
    EXPECT_EQ(program->ended(), 0) << program->error();
    EXPECT_TRUE(eventually([&] { return !isRunning(children.front()); }, 10.0));
    EXPECT_EQ(program->error(), "");
}

// One of ten seconds and more: nobody waits for it, and nothing of it is left.
TEST_F(Rest, CloseButtonDuringAScreenshot_EndsBoth)
{
    save(folder / "a.toml", still);
    open({"a.toml", "--spp", "64", "--screenshot", "8000x8000", "-o", "shot.png"});
    hand->tap("p");
    ASSERT_TRUE(eventually([&] { return program->children().size() == 2; }));
    std::this_thread::sleep_for(500ms);
    const auto children = program->children();
    hand->askToClose();
    EXPECT_EQ(program->ended(10.0), 0) << program->error();
    for (const pid_t child : children)
        EXPECT_TRUE(eventually([&] { return !isRunning(child); }, 10.0));
    for (const auto& file : std::filesystem::directory_iterator(folder))
        EXPECT_EQ(file.path().filename().string().find("shot"), std::string::npos) << file.path();
}

TEST_F(Rest, CloseButtonDuringAnEndlessShader_EndsAtOnce)
{
    save(folder / "a.frag", "void mainImage(out vec4 c, in vec2 p) { for (;;) {} }\n");
    start({"a.frag"});
    hand->askToClose();
    EXPECT_EQ(program->ended(10.0), 0) << program->error();
}

TEST_F(Rest, WithoutADisplay_IsRefusedWithItsMend)
{
    save(folder / "a.frag", green.shader());
    for (const std::string name : {"", ":54321"}) {
        environment["DISPLAY"] = name;
        program.emplace(folder, std::vector<std::string>{"a.frag", "--forget"}, environment);
        EXPECT_EQ(program->ended(), 69);
        EXPECT_NE(program->error().find("xvfb-run -a"), std::string::npos) << program->error();
        EXPECT_NE(program->error().find(name.empty() ? "there is no display" : ":54321"), std::string::npos)
            << program->error();
    }
}

TEST_F(Rest, ADisplayThatGoesAway_IsToldAndEndsTheWindow)
{
    auto own = std::make_unique<VirtualDisplay>();
    environment["DISPLAY"] = own->name();
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    const auto children = program->children();
    hand.reset();
    own.reset();
    EXPECT_EQ(program->ended(), 69);
    EXPECT_NE(program->error().find("the display went away"), std::string::npos) << program->error();
    for (const pid_t child : children)
        EXPECT_TRUE(eventually([&] { return !isRunning(child); }, 10.0));
}
