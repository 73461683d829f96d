// --view as a user types it.
#include "support/in_a_folder.h"

#include "base/picture.h"
#include "base/write_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

using namespace dioptre;
using dioptre::test::run;

namespace
{

using ViewCommand = test::InAFolder;

std::string texel(const Picture& picture, int x, int y)
{
    const auto i = static_cast<std::size_t>(4 * (y * picture.width + x));
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", picture.bytes[i], picture.bytes[i + 1],
                  picture.bytes[i + 2]);
    return text.data();
}

} // namespace

TEST_F(ViewCommand, Objects_HaveTheColoursThatTheLegendPrints)
{
    const auto outcome = here("dioptre render still_life --size 64x36 --spp 1 --view object -o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    // The lower edge of the picture is floor, the upper one sky.
    const auto picture = readPicture(folder / "a.png");
    EXPECT_NE(outcome.out.find(texel(picture, 0, 0) + "    0  floor, plane\n"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(texel(picture, 0, 35), "#000000");
    EXPECT_NE(outcome.out.find("#000000  nothing met"), std::string::npos);
}

TEST_F(ViewCommand, EveryView_PrintsALegend_AndPutsItIntoThePng)
{
    for (const char* view : {"rays", "lost", "object", "normal", "depth", "uv", "trust"}) {
        const auto outcome =
            here(std::string("dioptre render cylinders --size 32x18 --spp 1 -o a.png --view ") + view);
        ASSERT_EQ(outcome.code, 0) << outcome.error;
        const auto first = outcome.out.substr(0, outcome.out.find('\n'));
        EXPECT_GT(first.size(), 20U) << view;
        const auto chunks = here("strings -n 3 a.png").out;
        EXPECT_NE(chunks.find("dioptre.view"), std::string::npos);
        EXPECT_NE(chunks.find(first), std::string::npos) << chunks;
    }
}

TEST_F(ViewCommand, Json_HoldsTheFiguresInPlaceOfTheLegend)
{
    const auto figures = [&](const std::string& view) {
        return nlohmann::json::parse(
            here("dioptre render glass --size 64x36 --spp 1 --json -o a.png --view " + view).out)["view"];
    };
    const auto rays = figures("rays");
    EXPECT_EQ(rays["name"], "rays");
    EXPECT_EQ(rays["budget"], 24);
    EXPECT_GT(rays["mean"], 1.0);
    EXPECT_GT(rays["max"], rays["mean"]);
    EXPECT_GT(figures("lost")["cut_off_percent"], 0.0);
    EXPECT_GT(figures("depth")["farthest_m"], figures("depth")["nearest_m"]);
    EXPECT_EQ(figures("object")["objects"][3]["name"], "glass ball");
    EXPECT_FALSE(nlohmann::json::parse(here("dioptre render glass --size 16x9 --spp 1 --json -o a.png").out)
                     .contains("view"));
}

// A mirror ball within a mirror, off its middle: rays go astray for ever.
TEST_F(ViewCommand, PicturesBeyondTrust_AreWarnedOf_WithTheShareThatTheViewShows)
{
    const std::string mirrors =
        "[camera]\neye = [0, 0, 5]\n[trace]\nbudget = 40\n[sky]\ncolour = [1, 1, 1]\n"
        "[material.m]\nmirror = 1.0\n[[sphere]]\ncentre = [3, 1, 0]\nradius = 2\n"
        "material = \"m\"\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 9\nmaterial = \"m\"\n";
    writeFile(folder / "mirrors.toml", mirrors);
    const auto chaos = here("dioptre render mirrors.toml --size 64x36 --spp 1 --json -o a.png");
    EXPECT_EQ(chaos.code, 0);
    EXPECT_NE(chaos.error.find("% of the picture is beyond what single precision can tell: --view trust"),
              std::string::npos)
        << chaos.error;
    const double share = nlohmann::json::parse(chaos.out)["beyond_trust"];
    EXPECT_GT(share, 0.1);
    const auto view = nlohmann::json::parse(
        here("dioptre render mirrors.toml --size 64x36 --spp 1 --json -o b.png --view trust").out)["view"];
    EXPECT_NEAR(view["beyond_percent"].get<double>(), 100.0 * share, 5.0);
    const auto calm = here("dioptre render still_life --size 64x36 --spp 1 --json -o a.png");
    EXPECT_EQ(calm.error.find("beyond"), std::string::npos) << calm.error;
    EXPECT_LT(nlohmann::json::parse(calm.out)["beyond_trust"].get<double>(), 0.01);
    EXPECT_FALSE(nlohmann::json::parse(
                     here("dioptre render still_life --size 16x9 --spp 1 --json --reference -o a.png").out)
                     .contains("beyond_trust"));
}

// One ball comes in from outside: of the first frame all is sure.
TEST_F(ViewCommand, FramesBeyondTrust_AreWarnedOfByTheWorst)
{
    writeFile(folder / "mirrors.toml",
              "[camera]\neye = [0, 0, 5]\n[trace]\nbudget = 40\n[sky]\ncolour = [1, 1, 1]\n"
              "[material.m]\nmirror = 1.0\n[[sphere]]\nname = \"ball\"\ncentre = [40, 1, 0]\nradius = 2\n"
              "material = \"m\"\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 9\nmaterial = \"m\"\n"
              "[[animate]]\npath = \"ball.centre.0\"\ntimes = [0, 1]\nvalues = [40, 3]\n");
    const auto frames =
        here("dioptre render mirrors.toml --size 64x36 --spp 1 --json --frames 0:1 --fps 1 -o a.png");
    EXPECT_EQ(frames.code, 0) << frames.error;
    const auto rows = nlohmann::json::parse(frames.out)["frames"];
    EXPECT_LT(rows[0]["beyond_trust"].get<double>(), 0.01);
    EXPECT_GT(rows[1]["beyond_trust"].get<double>(), 0.1);
    EXPECT_NE(frames.error.find("% of frame 1, the worst, is beyond"), std::string::npos) << frames.error;
}

TEST_F(ViewCommand, Exr_HoldsTheNumbersThemselves)
{
    ASSERT_EQ(here("dioptre render glass --size 64x36 --spp 1 --view depth -o a.exr").code, 0);
    ASSERT_EQ(here("dioptre render glass --size 64x36 --spp 1 --view rays -o b.exr").code, 0);
    const auto depth = readPicture(folder / "a.exr");
    EXPECT_EQ(depth.floats[4 * 36 * 64 - 4], 0.0F) << "sky";
    EXPECT_GT(depth.floats[0], 1.0F);
    const auto rays = readPicture(folder / "b.exr");
    EXPECT_EQ(rays.floats[0], 1.0F);
    EXPECT_GT(*std::ranges::max_element(rays.floats), 8.0F);
}

TEST_F(ViewCommand, Normals_AreNotEncoded)
{
    // A floor's normal is (1/2, 1, 1/2); half of 255 rounds to 128, where sRGB would make it 188.
    ASSERT_EQ(here("dioptre render still_life --size 32x18 --spp 1 --view normal -o a.png").code, 0);
    EXPECT_EQ(texel(readPicture(folder / "a.png"), 0, 0), "#80ff80");
}

TEST_F(ViewCommand, WhereItMakesNoSense_IsRefused)
{
    EXPECT_EQ(here("dioptre render still_life --view colour -o a.png").code, 2);
    const auto reference = here("dioptre render still_life --view depth --reference -o a.png");
    EXPECT_EQ(reference.code, 2);
    EXPECT_NE(reference.error.find("--reference"), std::string::npos);
    const auto plain = here("printf 'out vec4 o;\\nvoid main()\\n{\\n    o = vec4(1.0);\\n}\\n' >p.frag && "
                            "dioptre render p.frag --view depth -o a.png");
    EXPECT_EQ(plain.code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_F(ViewCommand, Help_NamesEveryView)
{
    const auto help = here("dioptre render --help").out;
    for (const char* view : {"rays - ", "lost - ", "object - ", "normal - ", "depth - ", "uv - ", "trust - "})
        EXPECT_NE(help.find(view), std::string::npos) << view;
}
