// Rasterised pictures in the window, and two methods held against each other.
#include "base/file.h"
#include "support/in_a_window.h"

#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// A ball on both sides of the middle, with a shadow on the floor; it moves when time does.
const std::string ball = R"([camera]
eye = [0.0, 1.0, 6.0]
target = [0.0, 0.0, 0.0]
fov_y_deg = 40.0
[sky]
gradient = [[0.1, 0.1, 0.2], [0.3, 0.3, 0.4], [0.2, 0.4, 0.8]]
[material.red]
colour = [0.8, 0.3, 0.2]
mirror = 0.2
[[light]]
kind = "ambient"
ambient = [0.2, 0.2, 0.2]
[[light]]
kind = "point"
position = [3.0, 4.0, 4.0]
diffuse = [0.7, 0.7, 0.7]
[[sphere]]
name = "ball"
centre = [0.0, 0.0, 0.0]
radius = 1.4
material = "red"
[[plane]]
point = [0.0, -1.4, 0.0]
normal = [0.0, 1.0, 0.0]
)";
const std::string moving =
    ball + "[[animate]]\npath = \"ball.centre\"\ntimes = [0.0, 4.0]\nvalues = [[0, 0, 0], [2, 0, 0]]\n";

// Columns of a picture, from the first up to the last.
struct Columns {
    int first, last;
};
constexpr Columns all{0, 200}, left{0, 92}, right{108, 200};

class Methods : public InAWindow
{
protected:
    Methods()
    {
        save(folder / "a.toml", ball);
    }

    Picture still(const std::string& words, const std::string& file = "still.png") const
    {
        const auto outcome = here("dioptre render a.toml --spp 4 -o " + file + " " + words +
                                  (words.find("--size") == std::string::npos ? " --size 200x160" : ""));
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return readPicture(folder / file);
    }

    // In steps of 255, below the names and the notices: the window encodes on the device, a still on the CPU.
    static int farthest(const Picture& seen, const Picture& still, const Columns& columns)
    {
        if (seen.width != still.width || seen.height != still.height)
            return 256;
        int most = 0;
        for (int y = 0; y < seen.height * 90 / 160; ++y)
            for (int x = columns.first; x < columns.last; ++x) {
                const Rgb a = pixelOf(seen, x, y), b = pixelOf(still, x, y);
                most = std::max(
                    {most, std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
            }
        return most;
    }
    bool becomesAs(const Picture& still, const Columns& columns = all) const
    {
        return eventually([&] { return farthest(hand->see(), still, columns) <= 1; });
    }
    LiveProcess::Json openWith(std::vector<std::string> more)
    {
        more.insert(more.begin(), {"a.toml", "--spp", "4", "--paused"});
        const auto shown = open(more);
        program->next("done");
        return shown;
    }
    LiveProcess::Json tapFor(const std::string& key, const std::string& event)
    {
        hand->tap(key);
        return program->next(event);
    }
};

// The tracer's own shaders in a folder of the test.
class MethodsEdited : public Methods
{
protected:
    MethodsEdited()
    {
        std::filesystem::copy(std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl", folder / "glsl",
                              std::filesystem::copy_options::recursive);
        environment["DIOPTRE_GLSL"] = (folder / "glsl").string();
    }
    void edit(const std::string& file, const std::string& from, const std::string& to) const
    {
        const auto path = folder / "glsl" / file;
        std::string text = readFile(path);
        ASSERT_NE(text.find(from), std::string::npos) << file;
        save(path, text.replace(text.find(from), from.size(), to));
    }
};

} // namespace

TEST_F(Methods, EachMethod_IsAsInRender_AndFollowsSizeAndCamera)
{
    for (const std::string method : {"flat:8", "gouraud:8", "phong:16"}) {
        const auto shown = openWith({"--method", method});
        EXPECT_EQ(shown["method"], method);
        EXPECT_EQ(shown["comparison"], "off");
        EXPECT_TRUE(becomesAs(still("--method " + method))) << method;
    }
    hand->resize(260, 140);
    program->next("done");
    const Picture wide = still("--method phong:16 --size 260x140");
    EXPECT_TRUE(becomesAs(wide, {0, 260}));
    hand->wheel(-3);
    program->next("done");
    EXPECT_GT(farthest(settled(), wide, {0, 260}), 20);
    save(folder / "a.toml", ball + "[[sphere]]\ncentre = [-2, -1, 1]\nradius = 0.4\n");
    hand->tap("r");
    program->next("shown");
    program->next("done");
    EXPECT_TRUE(becomesAs(still("--method phong:16 --size 260x140"), {0, 260})) << "another scene";
}

TEST_F(Methods, Time_MovesFacetsAndTheirShadows)
{
    save(folder / "a.toml", moving);
    openWith({"--method", "phong:16"});
    EXPECT_TRUE(becomesAs(still("--method phong:16")));
    hand->tap("Right");
    program->next("done");
    EXPECT_TRUE(becomesAs(still("--method phong:16 --time 1")));
}

TEST_F(Methods, Split_HasOneMethodOnEachSide_OfADividerThatIsDragged)
{
    const Picture traced = still("", "a.png"), flat = still("--method flat:8", "b.png");
    ASSERT_GT(farthest(traced, flat, left), 20);
    ASSERT_GT(farthest(traced, flat, right), 20);
    const auto shown = openWith({"--compare", "flat:8"});
    EXPECT_EQ(shown["method"], "trace");
    EXPECT_EQ(shown["compare"], "flat:8");
    EXPECT_EQ(shown["comparison"], "split");
    EXPECT_TRUE(becomesAs(traced, left));
    EXPECT_TRUE(becomesAs(flat, right));
    hand->drag({103, 80}, {150, 100});
    const auto moved = program->next("comparison");
    EXPECT_NEAR(moved["divider_px"].get<int>(), 150, 1);
    hand->moveTo(30, 100);
    EXPECT_TRUE(becomesAs(traced, {0, 142})) << "the camera stays, and the tracer goes on to the divider";
    EXPECT_TRUE(becomesAs(flat, {158, 200}));
    hand->drag({60, 80}, {90, 90});
    program->next("done");
    EXPECT_GT(farthest(settled(), traced, {0, 142}), 20) << "beside the divider the camera is dragged";
    EXPECT_FALSE(program->nextIfThere("comparison"));
}

TEST_F(Methods, Flip_ShowsOneAndTheOtherInFull)
{
    const Picture traced = still("", "a.png"), flat = still("--method flat:8", "b.png");
    openWith({"--compare", "flat:8"});
    EXPECT_EQ(tapFor("x", "comparison")["comparison"], "second");
    EXPECT_TRUE(becomesAs(flat));
    EXPECT_EQ(tapFor("x", "comparison")["comparison"], "first");
    EXPECT_TRUE(becomesAs(traced));
}

// By radiance, which an EXR holds before any display.
TEST_F(Methods, Difference_IsOfRadianceTimesAScale)
{
    const Picture traced = still("", "a.exr"), flat = still("--method flat:8", "b.exr");
    openWith({"--compare", "flat:8"});
    const auto expectScale = [&](double scale) {
        const Picture seen = settled();
        int most = 0, brightest = 0;
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < width; ++x) {
                const auto i = 4 * static_cast<std::size_t>(y * width + x);
                const double apart = std::min(1.0, scale * std::abs(static_cast<double>(traced.floats[i]) -
                                                                    static_cast<double>(flat.floats[i])));
                const double encoded =
                    apart <= 0.0031308 ? 12.92 * apart : 1.055 * std::pow(apart, 1.0 / 2.4) - 0.055;
                most = std::max(
                    most, std::abs(pixelOf(seen, x, y).red - static_cast<int>(std::lround(255.0 * encoded))));
                brightest = std::max(brightest, pixelOf(seen, x, y).red);
            }
        EXPECT_LE(most, 2) << scale; // EXR's zip is exact; sums are scaled in another order
        EXPECT_GT(brightest, 50) << scale;
    };
    EXPECT_EQ(tapFor("b", "comparison")["scale"], 1);
    expectScale(1.0);
    EXPECT_EQ(tapFor("k", "comparison")["scale"], 2);
    EXPECT_EQ(tapFor("k", "comparison")["scale"], 4);
    expectScale(4.0);
    EXPECT_EQ(tapFor("b", "comparison")["comparison"], "off");
    program->next("done");
    EXPECT_TRUE(becomesAs(still("")));
}

TEST_F(Methods, DifferenceOfOneMethodFromItself_IsBlack)
{
    openWith({"--method", "gouraud:8", "--compare", "gouraud:8"});
    tapFor("b", "comparison");
    const Picture black{
        width, height, PixelFormat::srgb8, std::vector<std::uint8_t>(std::size_t{4} * width * height), {}};
    EXPECT_TRUE(becomesAs(black));
}

TEST_F(Methods, Edges_ComeAndGo)
{
    openWith({"--method", "phong:8"});
    const Picture plain = still("--method phong:8");
    EXPECT_TRUE(becomesAs(plain));
    EXPECT_EQ(tapFor("g", "comparison")["edges"], true);
    program->next("done");
    EXPECT_GT(farthest(settled(), plain, all), 50);
    hand->tap("g");
    EXPECT_TRUE(becomesAs(plain));
}

TEST_F(Methods, LeavingAMethod_LeavesNothingOnTheDevice)
{
    const auto settledObjects = [&] { return program->next("done")["gl_objects"].get<int>(); };
    open({"a.toml", "--spp", "2"});
    const int alone = settledObjects();
    for (int round = 0; round < 2; ++round) {
        tapFor("b", "shown"); // split
        const auto both = program->next("done");
        EXPECT_GT(both["gl_objects"].get<int>(), alone + 10);
        EXPECT_EQ(both["methods"].size(), 2U);
        EXPECT_EQ(both["methods"][1]["drawn"], 2);
        EXPECT_EQ(both["methods"][1]["culled"], 0);
        EXPECT_EQ(both["methods"][1]["shadow_maps"], 6);
        EXPECT_GT(both["methods"][1]["triangles"].get<int>(), 64 * 64);
        tapFor("b", "comparison"); // difference
        settled();
        tapFor("b", "shown"); // off
        EXPECT_EQ(settledObjects(), alone);
    }
}

TEST_F(Methods, Screenshot_HoldsBothSides_AndInAnotherSizeTheLeftOne)
{
    openWith({"--method", "flat:8", "--compare", "trace", "-o", "shot.png"});
    tapFor("p", "screenshot");
    const Picture shot = readPicture(folder / "shot-1.png");
    EXPECT_LE(farthest(shot, still("--method flat:8"), {0, 100}), 1);
    EXPECT_LE(farthest(shot, still(""), {100, 200}), 1);
    openWith({"--method", "flat:8", "--compare", "trace", "-o", "big.png", "--screenshot", "320x200"});
    tapFor("p", "screenshot");
    EXPECT_EQ(readPicture(folder / "big-1.png").bytes, still("--method flat:8 --size 320x200").bytes);
}

TEST_F(MethodsEdited, ShaderOfFacets_IsReloaded_AndAFaultyOneKeepsThePicture)
{
    openWith({"--method", "phong:8"});
    // All that is fed must be read still, as of the tracer.
    const std::string sum = "vec4(radiance, 0.0)",
                      painted = "vec4(vec3(0.0, 1.0, 0.0) + 1e-9 * radiance, 0.0)",
                      other = "vec4(vec3(0.0, 0.0, 1.0) + 1e-9 * radiance, 0.0)";
    edit("raster/surface.frag", sum, painted);
    EXPECT_EQ(program->next("shown")["compiled"], true);
    EXPECT_TRUE(eventually([&] { return at(freePlace) == green.rgb; }));
    edit("raster/surface.frag", painted, "vec4(nothing, 0.0)");
    const auto fault = program->next("error");
    EXPECT_EQ(fault["stale"], true);
    EXPECT_TRUE(fault["places"][0]["path"].get<std::string>().ends_with("raster/surface.frag")) << fault;
    EXPECT_GT(fault["places"][0]["line"].get<int>(), 50) << fault;
    EXPECT_TRUE(eventually([&] { return isStaleOver(green); }));
    edit("raster/surface.frag", "vec4(nothing, 0.0)", other);
    program->next("shown");
    EXPECT_TRUE(eventually([&] { return at(freePlace) == blue.rgb && !(at(border) == frameRed); }));
    edit("raster/surface.vert", "gl_Position = ", "gl_Position = 2 + missing * ");
    const auto placing = program->next("error");
    EXPECT_TRUE(placing["places"][0]["path"].get<std::string>().ends_with("raster/surface.vert")) << placing;
    EXPECT_TRUE(eventually([&] { return isStaleOver(blue); }));
}

TEST_F(Methods, WordsThatCannotBe_AreRefused)
{
    save(folder / "a.frag", green.shader());
    for (const std::string words :
         {"a.frag --method phong", "a.frag --compare phong", "a.toml --method phung",
          "a.toml --compare flat:1", "a.toml --method phong --view rays"}) {
        const auto outcome = here("dioptre live --json " + words);
        EXPECT_EQ(outcome.code, 2) << words << outcome.error;
    }
}
