// Pictures that are drawn in several bands and columns: each pixel is in its place, and memory does not grow
// with the picture.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

using namespace dioptre;

namespace
{

// Bytes that tell x and y apart up to 16384x1024: x mod 256, y mod 256, and the rest of both.
constexpr const char* placeFrag = R"(void mainImage(out vec4 o, in vec2 p)
{
    vec2 pixel = floor(p);
    vec2 high = floor(pixel / 256.0);
    o = vec4(mod(pixel, 256.0), high.x + 64.0 * high.y, 255.0) / 255.0;
}
)";

struct Place {
    int x = 0, y = 0; // from the lower left
};

Place placeIn(const std::uint8_t* byte)
{
    return {256 * (byte[2] % 64) + byte[0], 256 * (byte[2] / 64) + byte[1]};
}

class PictureOfBands : public test::InAFolder
{
protected:
    PictureOfBands()
    {
        std::ofstream(folder / "place.frag") << placeFrag;
    }

    // Width and height as the file's first chunk says: reading the pixels would take this process's memory.
    std::pair<int, int> sizeOfPng(const std::string& name) const
    {
        std::ifstream in(folder / name, std::ios::binary);
        std::string head(24, '\0');
        in.read(head.data(), 24);
        const auto number = [&](std::size_t at) {
            int value = 0;
            for (std::size_t i = at; i < at + 4; ++i)
                value = 256 * value + static_cast<unsigned char>(head[i]);
            return value;
        };
        return {number(16), number(20)};
    }
};

// 4 Mi pixels are drawn at once in whole groups of 64 rows, so at 9000 wide 448 rows, 8192 columns at most:
// a picture of two bands by two columns.
const std::string bandedSize = " --size 9000x600 ";

} // namespace

TEST_F(PictureOfBands, HasEachPixelInItsPlace)
{
    ASSERT_EQ(here("dioptre render place.frag -o a.png" + bandedSize).code, 0);
    const auto picture = readPicture(folder / "a.png");
    ASSERT_EQ(picture.width, 9000);
    ASSERT_EQ(picture.height, 600);
    std::size_t misplaced = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Place there = placeIn(&picture.bytes[4 * (9000 * static_cast<std::size_t>(y) + x)]);
            if ((there.x != x || there.y != y) && ++misplaced < 10)
                ADD_FAILURE() << "at " << x << "," << y << " is the pixel of " << there.x << "," << there.y;
        }
    EXPECT_EQ(misplaced, 0U);
}

// Fewer pixels than a band has, and more rows than are drawn at once.
TEST_F(PictureOfBands, ThatIsTallAndNarrow_HasEachPixelInItsPlace)
{
    std::ofstream(folder / "tall.frag")
        << "void mainImage(out vec4 o, in vec2 p)\n{\n"
           "    p = floor(p);\n"
           "    o = vec4(mod(p.y, 256.0), floor(p.y / 256.0), p.x, 255.0) / 255.0;\n}\n";
    ASSERT_EQ(here("dioptre render tall.frag -o a.exr --size 3x16000").code, 0);
    const auto picture = readPicture(folder / "a.exr");
    ASSERT_EQ(picture.height, 16000);
    std::size_t misplaced = 0;
    for (std::size_t pixel = 0; pixel < 3 * 16000; ++pixel) {
        const float* rgb = &picture.floats[4 * pixel];
        const float y = std::round(255.0F * rgb[0]) + 256.0F * std::round(255.0F * rgb[1]);
        misplaced += y != static_cast<float>(pixel / 3) ||
                     std::round(255.0F * rgb[2]) != static_cast<float>(pixel % 3);
    }
    EXPECT_EQ(misplaced, 0U);
}

// Tiles of 192 to 216 rows, whose edges are not those of bands.
TEST_F(PictureOfBands, IsTheFileOfItsTiles)
{
    std::ofstream(folder / "ball.toml") << "[camera]\neye = [0, 0, 5]\n[sky]\ngradient = [[0.1, 0.2, 0.3], "
                                           "[0.6, 0.5, 0.4], [0.7, 0.8, 0.9]]\n"
                                           "[material.m]\nmirror = 0.5\ncolour = [1, 0, 0]\n"
                                           "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
    for (const std::string what : {"place.frag", "ball.toml --spp 1"}) {
        const std::string command = "dioptre render " + what + bandedSize;
        const auto outcome =
            here(command + "-o whole.png && for i in 1 2 3; do " + command +
                 "--tile $i/3 -o $i.png || exit; done; dioptre join 2.png 3.png 1.png -o joined.png");
        ASSERT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_TRUE(readFile(folder / "joined.png") == readFile(folder / "whole.png")) << what;
    }
}

// Here 200 MiB, of which OpenGL takes a half; the picture at once would take 610 MiB as floats alone. The
// sanitizer, where there is one, is not to keep what was freed.
TEST_F(PictureOfBands, TakesNoMoreMemoryThanItsBands)
{
    const auto outcome = here("export ASAN_OPTIONS=$ASAN_OPTIONS:quarantine_size_mb=1; "
                              "dioptre render place.frag --size 20000x2000 -o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(sizeOfPng("a.png"), (std::pair{20000, 2000}));
    EXPECT_LT(outcome.peak_mib, 512.0);
}

TEST_F(PictureOfBands, Of240MillionPixels_TakesLessThanAGibibyte)
{
    const char* full = std::getenv("DIOPTRE_FULL");
    if (full == nullptr || std::string(full) != "yes")
        GTEST_SKIP() << "takes half a minute: tests/run --full";
    const auto outcome = here("dioptre render still_life --spp 1 --size 20000x12000 -o a.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(sizeOfPng("a.png"), (std::pair{20000, 12000}));
    EXPECT_LT(outcome.peak_mib, 1024.0);
}

// Its colours hang on all of its pixels together, which are not held.
TEST_F(PictureOfBands, OfAViewForTheEye_IsRefused)
{
    const auto outcome = here("dioptre render orrery --view depth --size 5000x4000 -o a.png");
    EXPECT_EQ(outcome.code, 2) << outcome.error;
    EXPECT_NE(outcome.error.find("--view depth takes its colours from the whole picture"), std::string::npos)
        << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}
