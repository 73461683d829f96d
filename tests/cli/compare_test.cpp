// `dioptre compare`: figures that can be worked out by hand, difference pictures, and reasons why not.
#include "base/file.h"
#include "base/picture.h"
#include "base/tone_curve.h"
#include "support/forged_pictures.h"
#include "support/in_a_folder.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

constexpr int wide = 24, high = 16;

class CompareCommand : public InAFolder
{
protected:
    // Rows from the bottom; of three numbers each.
    using Painter = std::function<std::array<float, 3>(int x, int y)>;

    static Picture painted(const Painter& colourAt, int columns = wide, int rows = high)
    {
        Picture picture = blankFloats(columns, rows);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const auto colour = colourAt(x, y);
                std::ranges::copy(colour, picture.floats.begin() + 4 * (y * columns + x));
            }
        return picture;
    }

    static Painter grey(float number)
    {
        return [number](int, int) { return std::array{number, number, number}; };
    }

    static Painter ramp(float factor)
    {
        return [factor](int x, int y) {
            return std::array{factor * static_cast<float>(x + 1) / wide, factor * 0.5f,
                              factor * static_cast<float>(y + 1) / high};
        };
    }

    void write(const std::string& name, const Picture& picture, int bits = 8) const
    {
        const auto path = folder / name;
        if (path.extension() == ".png")
            writePng(path, picture, {.encode = true, .gamma = {}, .bits = bits}, {});
        else if (path.extension() == ".hdr")
            writeRadiance(path, picture, {});
        else
            writeExr(path, picture, ExrDepth::full, {});
    }

    std::vector<std::string> temporaryFiles() const
    {
        std::vector<std::string> names;
        for (const auto& file : std::filesystem::directory_iterator(folder))
            if (file.path().filename().string().starts_with(".dioptre-"))
                names.push_back(file.path().filename());
        return names;
    }

    nlohmann::json figures(const std::string& arguments) const
    {
        const auto outcome = here("dioptre compare " + arguments + " --json");
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        return nlohmann::json::parse(outcome.out);
    }
};

} // namespace

TEST_F(CompareCommand, Radiance_IsMeasuredUnclamped)
{
    write("a.exr", painted(grey(2.0f)));
    write("b.exr", painted(grey(3.5f)));
    const auto found = figures("a.exr b.exr");
    EXPECT_EQ(found["reference"], "a.exr");
    EXPECT_EQ(found["picture"], "b.exr");
    EXPECT_EQ(found["size"], (std::vector<int>{wide, high}));
    EXPECT_DOUBLE_EQ(found["linear"]["rmse"], 1.5);
    EXPECT_DOUBLE_EQ(found["linear"]["mae"], 1.5);
    EXPECT_NEAR(found["linear"]["relmse"].get<double>(), std::pow(1.5 / 2.01, 2), 1e-12);
    EXPECT_DOUBLE_EQ(found["linear"]["max"], 1.5);
    EXPECT_EQ(found["display"]["psnr_db"], nullptr); // both beyond white
    EXPECT_EQ(found["display"]["psnr_peak"], 1.0);
    EXPECT_DOUBLE_EQ(found["display"]["ssim"], 1.0);
    EXPECT_EQ(found["flip"]["kind"], "hdr");
    EXPECT_EQ(found["flip"]["pixels_per_degree"], 67.0);
    EXPECT_EQ(found["flip"]["exposures"], 2);
    EXPECT_NEAR(found["flip"]["exposure_start"].get<double>(), std::log2(2.1188723 / 2.0), 1e-6);
    EXPECT_GT(found["flip"]["mean"], 0.1);
    EXPECT_EQ(found["nonfinite"]["reference"], 0);
    EXPECT_EQ(found["difference"], nullptr);
}

// -4 stops bring 2 and 3.5 to 0.125 and 0.21875, which sRGB encodes as 0.388573 and 0.505055.
TEST_F(CompareCommand, Exposure_ComesBeforeWhatADisplayShows)
{
    write("a.exr", painted(grey(2.0f)));
    write("b.hdr", painted(grey(3.5f)));
    const auto found = figures("a.exr b.hdr --exposure -4");
    EXPECT_EQ(found["display"]["exposure"], -4.0);
    EXPECT_NEAR(found["display"]["psnr_db"].get<double>(), -20.0 * std::log10(0.505055 - 0.388573), 1e-3);
    EXPECT_DOUBLE_EQ(found["linear"]["rmse"], 1.5); // as it stands
}

TEST_F(CompareCommand, LargestError_IsCountedFromTheUpperLeft)
{
    write("a.exr", painted(grey(0.5f)));
    write("b.exr", painted([](int x, int y) {
              return std::array{0.5f, x == 5 && y == 3 ? 2.0f : 0.5f, 0.5f};
          }));
    const auto found = figures("a.exr b.exr");
    EXPECT_EQ(found["linear"]["max"], 1.5);
    EXPECT_EQ(found["linear"]["max_at_px"], (std::vector<int>{5, high - 1 - 3}));
    const auto outcome = here("dioptre compare a.exr b.exr");
    EXPECT_NE(outcome.out.find("largest 1.5 at 5,12 from the upper left"), std::string::npos) << outcome.out;
}

// Codes 0 and 255; linear 0 and 1.
TEST_F(CompareCommand, PngsOfBlackAndWhite_DifferByAll)
{
    write("a.png", painted(grey(0.0f)));
    write("b.png", painted(grey(1.0f)));
    const auto found = figures("a.png b.png");
    EXPECT_EQ(found["linear"]["rmse"], 1.0);
    EXPECT_NEAR(found["display"]["psnr_db"].get<double>(), 0.0, 1e-12);
    EXPECT_EQ(found["flip"]["kind"], "ldr");
    EXPECT_FALSE(found["flip"].contains("exposures"));
    EXPECT_NEAR(found["flip"]["mean"].get<double>(), 0.9673798, 1e-6); // derived in flip_colour_test.cpp
    EXPECT_NEAR(found["flip"]["weighted_median"].get<double>(), 0.9673798, 1e-6);
}

TEST_F(CompareCommand, EqualPictures_AreCalledEqual)
{
    for (const std::string name : {"a.png", "a.hdr", "a.exr"}) {
        write(name, painted(ramp(0.9f)));
        const auto found = figures(name + " " + name);
        EXPECT_EQ(found["linear"]["rmse"], 0.0);
        EXPECT_EQ(found["linear"]["max"], 0.0);
        EXPECT_EQ(found["display"]["psnr_db"], nullptr);
        EXPECT_EQ(found["flip"]["mean"], 0.0);
        EXPECT_EQ(found["flip"]["max"], 0.0);
        const auto text = here("dioptre compare " + name + " " + name).out;
        EXPECT_NE(text.find("PSNR equal (peak 1), SSIM 1 (11x11"), std::string::npos) << text;
    }
}

// A PNG against the radiance that it was made of, by the same exposure and curve: nothing but 16 bits is
// lost.
TEST_F(CompareCommand, APngOfRadiance_IsThatRadianceByItsExposureAndCurve)
{
    const Picture radiance = painted(ramp(3.0f));
    write("a.exr", radiance);
    write("b.png", toned(radiance, {.exposure = 1.0, .curve = ToneCurve::filmic, .gamma = {}}), 16);
    const auto matched = figures("a.exr b.png --exposure 1 --curve filmic");
    EXPECT_GT(matched["display"]["psnr_db"], 90.0);
    EXPECT_EQ(matched["display"]["curve"], "filmic");
    EXPECT_EQ(matched["flip"]["kind"], "ldr");
    EXPECT_LT(matched["flip"]["mean"], 0.01);
    EXPECT_LT(figures("a.exr b.png")["display"]["psnr_db"], 30.0);
}

// Code 192 everywhere, which is linear 0.527115.
TEST_F(CompareCommand, Jpeg_IsDecodedFromSrgb)
{
    std::ofstream(folder / "a.jpg", std::ios::binary) << greyJpeg();
    write("b.exr", painted(grey(0.75f), 8, 8));
    write("c.png", painted(grey(0.75f), 8, 8));
    EXPECT_NEAR(figures("a.jpg b.exr")["linear"]["rmse"].get<double>(), 0.75 - 0.527115, 1e-6);
    EXPECT_EQ(figures("a.jpg b.exr")["flip"]["kind"], "ldr");
    EXPECT_EQ(figures("a.jpg c.png")["flip"]["kind"], "ldr");
    EXPECT_EQ(figures("a.jpg c.png")["display"]["ssim"], nullptr); // smaller than its window
}

TEST_F(CompareCommand, PixelsThatAreNotFinite_AreCountedSaidAndLeftOut)
{
    const auto holed = [](int x, int) { return std::array{x == 2 ? NAN : 1.0f, 1.0f, 1.0f}; };
    write("a.exr", painted(grey(1.0f)));
    write("b.exr", painted(holed));
    const auto found = figures("a.exr b.exr");
    EXPECT_EQ(found["nonfinite"]["reference"], 0);
    EXPECT_EQ(found["nonfinite"]["picture"], high);
    EXPECT_EQ(found["linear"]["rmse"], 0.0);
    EXPECT_EQ(found["flip"]["max"], 0.0);
    const auto text = here("dioptre compare a.exr b.exr").out;
    EXPECT_NE(text.find("0 pixels of the reference, 16 of the picture; left out of all figures"),
              std::string::npos)
        << text;
    write("none.exr", painted(grey(NAN)));
    const auto none = figures("a.exr none.exr");
    EXPECT_EQ(none["linear"]["rmse"], nullptr);
    EXPECT_EQ(none["display"]["ssim"], nullptr);
    EXPECT_EQ(none["flip"]["mean"], nullptr);
    EXPECT_NE(here("dioptre compare a.exr none.exr").out.find("RMSE undefined"), std::string::npos);
}

TEST_F(CompareCommand, ADifferenceInFloats_IsThatOfEachChannel)
{
    write("a.exr", painted([](int x, int) { return std::array{x == 2 ? NAN : 1.0f, 2.0f, 0.25f}; }));
    write("b.exr", painted([](int x, int y) {
              return std::array{0.5f, 10.0f, x == 7 && y == 1 ? 0.5f : 0.25f};
          }));
    EXPECT_EQ(figures("a.exr b.exr -o d.exr")["difference"], "d.exr");
    const Picture difference = readPicture(folder / "d.exr");
    const auto at = [&](int x, int y) { return linearTexel(difference, x, y); };
    EXPECT_EQ(at(0, 0), (std::array{0.5f, 8.0f, 0.0f, 1.0f}));
    EXPECT_EQ(at(7, 1)[2], 0.25f);
    EXPECT_TRUE(std::isnan(at(2, 5)[1]));
    figures("a.exr b.exr -o d.hdr");
    EXPECT_EQ(linearTexel(readPicture(folder / "d.hdr"), 0, 0)[1], 8.0f);
}

// Magma's ends are near black and pale yellow. Of two halves one differs by all, one not at all.
TEST_F(CompareCommand, ADifferenceAsPng_ShowsFlipInMagma)
{
    write("a.exr", painted([](int x, int) { return std::array{x == 3 ? NAN : 0.0f, 0.0f, 0.0f}; }, 80));
    write("b.exr", painted([](int x, int) { return std::array{0.0f, x < 40 ? 0.0f : 9.0f, 0.0f}; }, 80));
    figures("a.exr b.exr -o d.png");
    const Picture difference = readPicture(folder / "d.png");
    const auto byte = [&](int x, std::size_t channel) {
        return static_cast<int>(difference.bytes[static_cast<std::size_t>(4 * (8 * 80 + x)) + channel]);
    };
    EXPECT_LT(byte(12, 0) + byte(12, 1) + byte(12, 2), 12);
    EXPECT_GT(byte(70, 0), 200);
    EXPECT_GT(byte(70, 1), 100);
    EXPECT_EQ(byte(3, 0), 0); // green: not finite
    EXPECT_EQ(byte(3, 1), 255);
    EXPECT_EQ(byte(3, 2), 0);
    EXPECT_EQ(readSettings(folder / "d.png")["dioptre.shows"],
              "HDR-FLIP at 67 pixels a degree, 0 to 1 in magma; green: not finite");
}

TEST_F(CompareCommand, PixelsPerDegree_ChangeFlip)
{
    const auto stripes = [](int x, int) { return std::array{x % 2 == 0 ? 0.0f : 1.0f, 0.5f, 0.5f}; };
    write("a.png", painted(grey(0.5f)));
    write("b.png", painted(stripes));
    const double near = figures("a.png b.png --ppd 20")["flip"]["mean"],
                 far = figures("a.png b.png --ppd 200")["flip"]["mean"];
    EXPECT_GT(near, 1.2 * far);
}

// A limit on the size of files stands for a full disk.
TEST_F(CompareCommand, AFullDisk_LeavesTheOldFile)
{
    for (const std::string kind : {"png", "hdr", "exr"}) {
        unsigned state = 1;
        const auto noise = [&state](int, int) {
            std::array<float, 3> colour{};
            for (float& number : colour)
                number = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 0x1p24f;
            return colour;
        };
        write("a.exr", painted(grey(0.0f), 128, 128));
        write("b.exr", painted(noise, 128, 128));
        here("printf old >d." + kind);
        const auto outcome = here("trap '' XFSZ; ulimit -f 8; dioptre compare a.exr b.exr -o d." + kind);
        EXPECT_EQ(outcome.code, 73) << outcome.error;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(readFile(folder / ("d." + kind)), "old");
    }
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(folder))
        ++files;
    EXPECT_EQ(files, 5U); // a, b and three that are old
}

// 60 stops in as many steps: long enough to be stopped.
TEST_F(CompareCommand, ASignal_EndsItAndLeavesTheOldFile)
{
    write("a.exr", painted(
                       [](int x, int y) {
                           return std::array{x + y == 0 ? 0x1p60f : 1.0f, 1.0f, 1.0f};
                       },
                       900, 600));
    write("b.exr", painted(grey(1.0f), 900, 600));
    here("printf old >d.png");
    // The file is made under a temporary name once signals are heard.
    const auto outcome = runAndSignal(folder, "compare a.exr b.exr -o d.png", SIGINT,
                                      [this](int) { return !temporaryFiles().empty(); });
    EXPECT_EQ(outcome.signal, SIGINT);
    EXPECT_NE(outcome.error.find("stopped by a signal, and nothing was written"), std::string::npos)
        << outcome.error;
    EXPECT_EQ(readFile(folder / "d.png"), "old");
    EXPECT_EQ(temporaryFiles(), std::vector<std::string>{});
}
