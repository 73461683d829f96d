// Tiles put together: to the very file of one machine, or a reason why not.
#include "base/file.h"
#include "base/picture.h"
#include "base/tile_rows.h"
#include "support/in_a_folder.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace dioptre;

namespace
{

constexpr int width = 50, height = 200; // four groups of rows, the top one cut off

// What a picture is, and what tiles of it may be made to say.
struct Drawing {
    std::string kind = "png";
    PngForm form{};
    ExrDepth depth = ExrDepth::full;
    bool layers = false;
    Settings settings = {{"Software", "dioptre 0.1.0"},
                         {"dioptre.input", "orrery"},
                         {"dioptre.legend", "one\ntwo"},
                         {"dioptre.set", "title=Sch\xC3\xB6n"},
                         {"dioptre.size", "50x200"}};
    std::string hash = "0123456789abcdef";
};

class JoinCommand : public test::InAFolder
{
protected:
    // Rows of one smooth picture, counted from the bottom.
    void writeRows(const std::string& name, const Drawing& drawing, const Settings& settings, TileRows rows)
    {
        Picture picture{width, rows.count, PixelFormat::float32, {}, {}};
        ExrLayer layer{"depth.Z", {}};
        for (int i = width * rows.first; i < width * (rows.first + rows.count); ++i) {
            const auto t = static_cast<float>(i) / (width * height);
            picture.floats.insert(picture.floats.end(), {t, std::abs(std::sin(90 * t)), 1 - t, 1});
            layer.numbers.push_back(100 * t);
        }
        if (drawing.kind == "png")
            writePng(folder / name, picture, drawing.form, settings);
        else if (drawing.kind == "hdr")
            writeRadiance(folder / name, picture, settings);
        else
            writeExr(folder / name, picture, drawing.depth, settings,
                     drawing.layers ? std::vector{layer} : std::vector<ExrLayer>{});
    }

    // As `render --tile` writes it; "a1.png" is the first of a.
    void writeTile(const std::string& name, const Drawing& drawing, int tile, int tiles)
    {
        Settings settings = drawing.settings;
        settings["dioptre.tile"] = std::to_string(tile) + "/" + std::to_string(tiles);
        settings["dioptre.hash"] = drawing.hash;
        writeRows(name, drawing, settings, tileRows(height, tile, tiles));
    }

    std::set<std::string> files() const
    {
        std::set<std::string> names;
        for (const auto& file : std::filesystem::directory_iterator(folder))
            names.insert(file.path().filename());
        return names;
    }

    // With nothing written, and what was there left alone.
    void expectRefused(const std::string& arguments, int code, const std::vector<std::string>& words)
    {
        here("printf old >old.png; cp old.png old.exr");
        const auto before = files();
        const auto outcome = here("dioptre join " + arguments);
        EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.error;
        EXPECT_EQ(outcome.out, "");
        for (const auto& word : words)
            EXPECT_NE(outcome.error.find(word), std::string::npos) << word << " not in " << outcome.error;
        EXPECT_EQ(readFile(folder / "old.png"), "old") << arguments;
        EXPECT_EQ(files(), before) << arguments;
    }
};

const std::vector<Drawing> drawings = {
    {},
    {.form = {.encode = true, .gamma = 2.2, .bits = 16}},
    {.form = {.encode = false, .gamma = {}, .bits = 16}},
    {.kind = "hdr"},
    {.kind = "exr"},
    {.kind = "exr", .depth = ExrDepth::half, .layers = true},
};

} // namespace

TEST_F(JoinCommand, Tiles_BecomeTheFileOfOneMachine_WhateverTheirOrder)
{
    for (const Drawing& drawing : drawings)
        for (const int tiles : {1, 3, 4}) {
            std::string parts;
            for (int tile = 1; tile <= tiles; ++tile) {
                const std::string name = "t" + std::to_string(tile) + "." + drawing.kind;
                writeTile(name, drawing, tile, tiles);
                parts = tile % 2 == 0 ? parts + " " + name : name + " " + parts;
            }
            const std::string whole = "whole." + drawing.kind, joined = "joined." + drawing.kind;
            writeRows(whole, drawing, drawing.settings, {0, height});
            const auto outcome = here("dioptre join " + parts + " -o " + joined);
            EXPECT_EQ(outcome.code, 0) << outcome.error;
            EXPECT_EQ(outcome.out, "");
            EXPECT_EQ(outcome.error, joined + ": 50x200 of " + std::to_string(tiles) + " tiles\n");
            EXPECT_TRUE(readFile(folder / joined) == readFile(folder / whole)) << parts;
        }
}

TEST_F(JoinCommand, Json_TellsWhatWasWritten)
{
    writeTile("1.png", {}, 1, 2);
    writeTile("2.png", {}, 2, 2);
    const auto outcome = here("dioptre join 1.png 2.png -o a.png --json");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto figures = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(figures["output"], "a.png");
    EXPECT_EQ(figures["size"], (std::vector<int>{width, height}));
    EXPECT_EQ(figures["tiles"], 2);
    EXPECT_GT(figures["total_ms"], 0.0);
}

TEST_F(JoinCommand, TilesThatDoNotMakeUpAPicture_AreRefused)
{
    writeTile("1.png", {}, 1, 4);
    writeTile("3.png", {}, 3, 4);
    writeTile("half.png", {}, 2, 2);
    expectRefused("3.png 1.png -o old.png", 65, {"of 4 tiles 2, 4 are missing"});
    expectRefused("1.png 3.png 1.png -o old.png", 65, {"1.png: is tile 1 of 4, as 1.png is"});
    expectRefused("1.png half.png -o old.png", 65, {"half.png: is tile 2 of 2, and 1.png is one of 4"});
    writeRows("plain.png", {}, Drawing{}.settings, {0, height});
    expectRefused("1.png plain.png -o old.png", 65, {"plain.png: does not say which tile", "--tile"});
    Settings settings = Drawing{}.settings;
    settings["dioptre.hash"] = Drawing{}.hash;
    settings["dioptre.tile"] = "1/4";
    writeRows("tall.png", {}, settings, {0, 64});
    expectRefused("tall.png -o old.png", 65,
                  {"tall.png: is 50x64, and tile 1 of 4 of a 50x200 picture is 50x8"});
    for (const std::string tile : {"0/4", "5/4", "1/5", "1", "1/", "a/4", "1/4x", "99999999999/4", "-1/4"}) {
        settings["dioptre.tile"] = tile;
        writeRows("odd.png", {}, settings, {0, 64});
        expectRefused("odd.png -o old.png", 65, {"odd.png: its text says tile " + tile});
    }
}

TEST_F(JoinCommand, TilesOfDifferentPictures_AreRefusedAndTheDifferenceIsNamed)
{
    writeTile("1.png", {}, 1, 2);
    Drawing other;
    other.settings["dioptre.spp"] = "16";
    other.settings["dioptre.time"] = "2";
    writeTile("2.png", other, 2, 2);
    expectRefused("1.png 2.png -o old.png", 65, {"2.png: its dioptre.spp is '16', and nothing of 1.png"});
    other = {};
    other.settings["dioptre.input"] = "glass";
    other.hash = "fedcba9876543210";
    writeTile("2.png", other, 2, 2);
    expectRefused("1.png 2.png -o old.png", 65,
                  {"2.png: its dioptre.input is 'glass', and 'orrery' of 1.png"});
    other = {};
    other.hash = "fedcba9876543210";
    writeTile("2.png", other, 2, 2);
    expectRefused(
        "1.png 2.png -o old.png", 65,
        {"2.png: was drawn from another scene, other shaders or pictures, or with other options than 1.png"});
    writeTile("2.png", {.form = {.encode = true, .gamma = {}, .bits = 16}}, 2, 2);
    expectRefused("1.png 2.png -o old.png", 65,
                  {"2.png: holds 16 bits a channel, and 1.png holds 8 bits a channel"});
    writeTile("2.hdr", {.kind = "hdr"}, 2, 2);
    expectRefused("1.png 2.hdr -o old.png", 65, {"2.hdr: is Radiance HDR, another kind of file (PNG)"});
    writeTile("1.exr", {.kind = "exr"}, 1, 2);
    writeTile("2.exr", {.kind = "exr", .layers = true}, 2, 2);
    expectRefused("1.exr 2.exr -o old.exr", 65,
                  {"2.exr: holds channels B:32 G:32 R:32 depth.Z:32, and 1.exr"});
}

TEST_F(JoinCommand, BrokenParts_AreRefusedAndTheOldFileStays)
{
    for (const std::string kind : {"png", "hdr", "exr"}) {
        writeTile("1." + kind, {.kind = kind}, 1, 2);
        writeTile("2." + kind, {.kind = kind}, 2, 2);
        const auto cut = folder / ("2." + kind);
        std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 1);
        expectRefused("1." + kind + " 2." + kind + " -o new." + kind, 65, {"2." + kind + ": ", "cut short"});
    }
    here("printf 'no picture' >text.png; : >empty.png");
    expectRefused("text.png -o old.png", 65, {"text.png: is no PNG, Radiance HDR or EXR"});
    expectRefused("empty.png -o old.png", 65, {"empty.png: is no PNG"});
    expectRefused("1.png absent.png -o old.png", 66, {"absent.png: cannot be read"});
    expectRefused(". -o old.png", 66, {".: is a folder"});
}

TEST_F(JoinCommand, OutputsThatCannotBe_AreRefused)
{
    writeTile("1.png", {}, 1, 1);
    expectRefused("1.png -o ./1.png", 2, {"-o ./1.png is one of the parts"});
    expectRefused("1.png -o old.exr", 2, {"-o old.exr is of another kind than the parts, which are PNG"});
    expectRefused("1.png -o a.gif", 2, {"none of .png, .hdr and .exr"});
    expectRefused("1.png", 2, {"--output is required"});
    expectRefused("-o old.png", 2, {"parts is required"});
    expectRefused("1.png -o absent/a.png", 73, {"absent/a.png: there is no folder absent"});
}

// A limit on the size of files stands for a full disk.
TEST_F(JoinCommand, AFullDisk_LeavesTheOldFile)
{
    for (const std::string kind : {"png", "hdr", "exr"}) {
        const Drawing drawing{.kind = kind, .form = {.encode = true, .gamma = {}, .bits = 16}};
        writeTile("1." + kind, drawing, 1, 1);
        here("printf old >a." + kind);
        const auto before = files();
        const auto outcome = here("trap '' XFSZ; ulimit -f 8; dioptre join 1." + kind + " -o a." + kind);
        EXPECT_EQ(outcome.code, 73) << outcome.error;
        EXPECT_NE(outcome.error.find("could not be written to its end: make room"), std::string::npos);
        EXPECT_EQ(readFile(folder / ("a." + kind)), "old");
        EXPECT_EQ(files(), before);
    }
}
