// The backend with a window: a headless run's twin where there is a display, a reason where there is none.
#include "base/file.h"
#include "base/picture.h"
#include "support/display.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

using namespace dioptre;

namespace
{

using Json = nlohmann::json;

// Cuts out what stands under a name, so that the rest can be compared: PNG's chunk of length, kind, text and
// sum, or the line in an HDR's head.
std::string without(const std::string& text, std::string file)
{
    const auto name = file.find(text);
    EXPECT_NE(name, std::string::npos) << "the file has no " << text;
    if (name == std::string::npos)
        return file;
    if (!file.starts_with("\x89PNG"))
        return file.erase(name, file.find('\n', name) + 1 - name);
    std::size_t length = 0;
    for (std::size_t i = name - 8; i < name - 4; ++i)
        length = 256 * length + static_cast<unsigned char>(file[i]);
    return file.erase(name - 8, 12 + length);
}

class Window : public test::InAFolder
{
protected:
    // One server for all tests here, ended with the program.
    static const test::VirtualDisplay& display()
    {
        static const test::VirtualDisplay shared;
        return shared;
    }

    test::Outcome under(const std::string& displayName, const std::string& command) const
    {
        return here("export DISPLAY='" + displayName + "'; " + command);
    }
    test::Outcome withDisplay(const std::string& command) const
    {
        return under(display().name(), command);
    }
    test::Outcome withoutDisplay(const std::string& command) const
    {
        return here("unset DISPLAY; " + command);
    }

    // As files window.EXTENSION and headless.EXTENSION.
    void drawBoth(const std::string& arguments, const std::string& extension) const
    {
        const std::string render = "dioptre render " + arguments;
        const auto window = withDisplay(render + " --backend window -o window." + extension);
        ASSERT_EQ(window.code, 0) << window.error;
        EXPECT_NE(window.error.find("window ("), std::string::npos) << window.error;
        const auto headless = withoutDisplay(render + " --backend egl-surfaceless -o headless." + extension);
        ASSERT_EQ(headless.code, 0) << headless.error;
    }
    std::string file(const std::string& name) const
    {
        return readFile(folder / name);
    }
    void expectAlikeButForBackend(const std::string& ending) const
    {
        const std::string window = file("window." + ending), headless = file("headless." + ending);
        EXPECT_FALSE(window == headless) << "both name one backend";
        EXPECT_TRUE(without("dioptre.backend", window) == without("dioptre.backend", headless));
    }

    // Ends with 69, says each of the fragments in one line, and leaves no file.
    void expectNoWindow(const test::Outcome& outcome, const std::vector<std::string>& fragments) const
    {
        EXPECT_EQ(outcome.code, 69);
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        for (const auto& fragment : fragments)
            EXPECT_NE(outcome.error.find(fragment), std::string::npos) << "'" << fragment << "' not in\n"
                                                                       << outcome.error;
        EXPECT_TRUE(std::filesystem::is_empty(folder));
    }
};

class Twin : public Window, public testing::WithParamInterface<std::pair<const char*, const char*>>
{
};

INSTANTIATE_TEST_SUITE_P(
    Inputs, Twin,
    testing::Values(std::pair{"Scene", "still_life --size 160x90 --spp 2"},
                    std::pair{"AnimatedSceneOfOddSize", "orrery --size 67x41 --spp 1 --time 2.5"},
                    std::pair{"View", "glass --size 64x36 --spp 1 --view normal"},
                    std::pair{"PlainShader",
                              "'" DIOPTRE_SOURCE_DIR "/tests/shaders/kernels.frag' --size 64x36 --time 1.5"}),
    [](const auto& info) { return info.param.first; });

const std::string spheres = "dioptre render spheres --size 16x9 --spp 1 -o a.png --backend window";

Json rowOfWindow(const Json& findings)
{
    for (const auto& row : findings["backends"])
        if (row["backend"] == "window")
            return row;
    return {};
}

} // namespace

TEST_P(Twin, Png_IsTheHeadlessOneToTheByte)
{
    drawBoth(GetParam().second, "png");
    expectAlikeButForBackend("png");
}

// The names' lengths shift an EXR's bytes, so its numbers are compared.
TEST_P(Twin, Exr_HoldsTheHeadlessFloats)
{
    drawBoth(GetParam().second, "exr");
    const auto window = readPicture(folder / "window.exr"), headless = readPicture(folder / "headless.exr");
    ASSERT_FALSE(window.floats.empty());
    EXPECT_EQ(std::pair(window.width, window.height), std::pair(headless.width, headless.height));
    EXPECT_EQ(std::memcmp(window.floats.data(), headless.floats.data(),
                          std::min(window.floats.size(), headless.floats.size()) * sizeof(float)),
              0);
}

TEST_F(Window, Hdr_IsTheHeadlessOneToTheByte)
{
    drawBoth("still_life --size 64x36 --spp 1", "hdr");
    expectAlikeButForBackend("hdr");
}

// Each holds a fingerprint of the options, the backend among them.
TEST_F(Window, Frames_AreTheHeadlessOnes)
{
    drawBoth("orrery --size 32x18 --spp 1 --frames 0:1", "png");
    for (const std::string number : {".0000.png", ".0001.png"})
        EXPECT_TRUE(without("dioptre.hash", without("dioptre.backend", file("window" + number))) ==
                    without("dioptre.hash", without("dioptre.backend", file("headless" + number))))
            << number;
}

TEST_F(Window, Bench_NamesIt)
{
    const auto outcome =
        withDisplay("dioptre bench spheres --size 16x9 --frames 6 --cold 1 --json --backend window");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(Json::parse(outcome.out)["backend"], "window");
}

TEST_F(Window, WithoutDisplay_IsRefusedWithItsMend)
{
    const std::vector<std::string> words{"window: there is no display", "set DISPLAY", "xvfb-run -a",
                                         "another --backend"};
    expectNoWindow(withoutDisplay(spheres), words);
    expectNoWindow(under("", spheres), words);
}

TEST_F(Window, ADisplayThatDoesNotAnswer_IsRefusedByItsName)
{
    expectNoWindow(under(":54321", spheres), {"Failed to open display :54321", "set DISPLAY", "xvfb-run -a"});
}

TEST_F(Window, ADisplayWithoutOpenGl_IsRefused)
{
    const test::VirtualDisplay bare({"-extension", "GLX"});
    expectNoWindow(under(bare.name(), spheres), {"no window for OpenGL 3.3 core (GLX: ", "libgl1-mesa-dri"});
}

// One that lacks every function is as good as none.
TEST_F(Window, WithoutGlfw_IsRefusedAndNamesThePackage)
{
    const std::string elsewhere = "mkdir \"$TMP\" && cc -shared -x c /dev/null -o \"$TMP/libglfw.so.3\" && "
                                  "export LD_LIBRARY_PATH=\"$TMP\"; " +
                                  spheres + "; code=$?; rm -r \"$TMP\"; exit $code";
    expectNoWindow(withDisplay("TMP=$PWD-glfw; " + elsewhere), {"install the package libglfw3"});
}

TEST_F(Window, Auto_NeverTakesIt)
{
    const auto outcome = withDisplay("__EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre render spheres --size 16x9 "
                                     "--spp 1 -o a.png --backend egl");
    EXPECT_EQ(outcome.code, 69);
    EXPECT_EQ(outcome.error.find("window"), std::string::npos) << outcome.error;
}

TEST_F(Window, DoctorWithoutDisplay_TellsThatAndPasses)
{
    const auto json = withoutDisplay("dioptre doctor --json");
    EXPECT_EQ(json.code, 0) << json.error;
    const Json row = rowOfWindow(Json::parse(json.out));
    EXPECT_EQ(row["works"], false);
    EXPECT_EQ(row["absent"], true);
    EXPECT_EQ(row["ended_process"], false);
    const auto text = withoutDisplay("dioptre doctor");
    EXPECT_EQ(text.code, 0) << text.error;
    EXPECT_NE(text.out.find("not here: there is no display"), std::string::npos) << text.out;
}

TEST_F(Window, DoctorWithDisplay_TriesItAndExaminesTheHeadlessOne)
{
    const auto outcome = withDisplay("dioptre doctor --json");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(rowOfWindow(json)["works"], true);
    EXPECT_NE(json["backend"], "window");
}

TEST_F(Window, DoctorOfTheWindow_ExaminesItOrSaysWhatItNeeds)
{
    const auto with = withDisplay("dioptre doctor --json --backend window");
    EXPECT_EQ(with.code, 0) << with.error;
    EXPECT_EQ(Json::parse(with.out)["backend"], "window");
    const auto without = withoutDisplay("dioptre doctor --backend window");
    EXPECT_EQ(without.code, 69);
    EXPECT_NE(without.out.find("verdict: no OpenGL 3.3 here: set DISPLAY"), std::string::npos) << without.out;
}

// Neither EGL's drivers nor OSMesa.
TEST_F(Window, DoctorWhereItAloneWorks_NamesIt)
{
    const auto outcome =
        withDisplay("cc -shared -x c /dev/null -o libOSMesa.so.8 && cp libOSMesa.so.8 libOSMesa.so.6 && cp "
                    "libOSMesa.so.8 libOSMesa.so && LD_LIBRARY_PATH=$PWD __EGL_VENDOR_LIBRARY_DIRS=/nowhere "
                    "dioptre doctor");
    EXPECT_EQ(outcome.code, 69) << outcome.error;
    EXPECT_NE(outcome.out.find("verdict: no OpenGL 3.3 here: name --backend window, or install"),
              std::string::npos)
        << outcome.out;
}
