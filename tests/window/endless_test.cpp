// Shaders that no driver likes: the window lives on, says so, and shows the next good edit.
#include "support/in_a_window.h"

#include <csignal>
#include <set>
#include <thread>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// So large that a compiler is at work on it for a while; all of it ends in one colour.
std::string largeShader(const Paint& paint)
{
    std::string text, sum;
    for (int i = 0; i < 12; ++i) {
        const std::string name = "f" + std::to_string(i), number = std::to_string(i) + ".5";
        text += "float " + name + "(vec2 p)\n{\n    float s = " + number +
                ";\n    for (int i = 0; i < 12; ++i)\n        s = sin(s * p.x + float(i)) * cos(p.y * s + " +
                number + ") + exp(-s * s) * mod(s, 1.0 + abs(p.x));\n    return s;\n}\n";
        sum += " + " + name + "(p)";
    }
    return text + "void mainImage(out vec4 c, in vec2 p)\n{\n    float s = 0.0" + sum + ";\n    c = vec4(" +
           paint.vector() + ", 1.0) + (s > 1e6 ? 1.0 : 0.0);\n}\n";
}

class Endless : public InAWindow
{
protected:
    Endless()
    {
        environment["MESA_SHADER_CACHE_DIR"] = (folder / "driver").string(); // a cold one
    }

    // The one process beside the window, where shaders are tried.
    pid_t helper() const
    {
        const auto children = program->children();
        return children.size() == 1 ? children.front() : 0;
    }
};

} // namespace

TEST_F(Endless, Loops_AreToldAndTheNextEditIsShown)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag", "--draw-limit", "1"});
    ASSERT_TRUE(becomes(green));
    const std::string head = "void mainImage(out vec4 c, in vec2 p)\n{\n    c = vec4(0.0);\n";
    for (const std::string loop :
         {"for (;;) {}", "while (true) c += vec4(0.001) * p.x;", "for (int i = 0; i < 2; i += 0) c.x += 1.0;",
          "do c = sin(c + iTime); while (c.x < 9.0);"}) {
        save(folder / "a.frag", head + "    " + loop + "\n}\n");
        const auto event = program->next("error");
        EXPECT_NE(event["text"].get<std::string>().find("loop"), std::string::npos) << event;
        EXPECT_TRUE(eventually([&] { return isStaleOver(green); })) << loop;
        save(folder / "a.frag", green.shader());
        EXPECT_TRUE(becomes(green)) << loop;
    }
}

TEST_F(Endless, HelperThatDies_IsToldAndTheNextEditIsShown)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    ASSERT_TRUE(becomes(green));
    const pid_t first = helper();
    ASSERT_NE(first, 0);
    const double before_s = cpuOf_s(first);
    save(folder / "a.frag", largeShader(blue));
    ASSERT_TRUE(eventually([&] { return cpuOf_s(first) > before_s + 0.1; })) << "it does not compile";
    ::kill(first, SIGSEGV);
    const auto event = program->next("error");
    EXPECT_NE(event["text"].get<std::string>().find("the driver crashed over this shader"), std::string::npos)
        << event;
    EXPECT_TRUE(eventually([&] { return isStaleOver(green); }));
    save(folder / "a.frag", white.shader());
    EXPECT_TRUE(becomes(white));
    EXPECT_NE(helper(), first);
}

TEST_F(Endless, HelperThatDiesIdle_IsReplacedUnseen)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    ASSERT_TRUE(becomes(green));
    for (const Paint* paint : {&blue, &white, &yellow}) {
        const pid_t helperBefore = helper();
        ::kill(helperBefore, SIGKILL);
        save(folder / "a.frag", paint->shader());
        program->next("shown");
        EXPECT_TRUE(becomes(*paint)) << paint->letter;
        EXPECT_FALSE(program->nextIfThere("error"));
        EXPECT_NE(helper(), helperBefore);
    }
}

// By somebody, or by a system that is short of memory: that tells nothing of the shader.
TEST_F(Endless, HelperThatIsKilledAtWork_IsReplacedOnceUnseen)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    ASSERT_TRUE(becomes(green));
    const auto killAtWork = [&] {
        const pid_t working = helper();
        const double before_s = cpuOf_s(working);
        ASSERT_TRUE(eventually([&] { return cpuOf_s(working) > before_s + 0.1; })) << "it does not compile";
        ::kill(working, SIGKILL);
        EXPECT_TRUE(eventually([&] { return helper() != working && helper() != 0; }));
    };
    save(folder / "a.frag", largeShader(blue));
    killAtWork();
    program->next("shown");
    EXPECT_TRUE(becomes(blue));
    save(folder / "a.frag", largeShader(white));
    killAtWork();
    killAtWork();
    const auto event = program->next("error");
    EXPECT_NE(event["text"].get<std::string>().find("was killed, twice"), std::string::npos) << event;
    EXPECT_TRUE(eventually([&] { return isStaleOver(blue); }));
}

// A frame shows a moment: as many colours were seen as frames were.
TEST_F(Endless, SlowCompile_LetsThePictureRunOn)
{
    save(folder / "a.frag",
         "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(iTime * vec3(1.0, 3.7, 11.3)), 1.0); }");
    open({"a.frag"});
    const pid_t first = helper();
    const double before_s = cpuOf_s(first);
    save(folder / "a.frag", largeShader(blue));
    ASSERT_TRUE(eventually([&] { return cpuOf_s(first) > before_s + 0.1; })) << "it does not compile";
    std::set<std::array<int, 3>> colours;
    EXPECT_TRUE(eventually(
        [&] {
            const Rgb seen = at(freePlace);
            if (program->nextIfThere("shown"))
                return true;
            colours.insert({seen.red, seen.green, seen.blue});
            return false;
        },
        120.0));
    EXPECT_GT(colours.size(), 5U);
    EXPECT_TRUE(becomes(blue));
}

// What is edited while the compiler is at work is not made to wait for it.
TEST_F(Endless, EditDuringASlowCompile_TakesItsPlace)
{
    save(folder / "a.frag", green.shader());
    open({"a.frag"});
    ASSERT_TRUE(becomes(green));
    const pid_t first = helper();
    const double before_s = cpuOf_s(first);
    save(folder / "a.frag", largeShader(blue));
    ASSERT_TRUE(eventually([&] { return cpuOf_s(first) > before_s + 0.1; })) << "it does not compile";
    save(folder / "a.frag", white.shader());
    EXPECT_EQ(program->next("shown")["number"], 3);
    EXPECT_TRUE(becomes(white));
    EXPECT_FALSE(isRunning(first));
}
