// Many frames by one command: names, times, what is kept, and what is refused.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace dioptre;

namespace
{

const std::string smallFrames = " --size 32x18 --spp 1 ";

class FramesCommand : public test::InAFolder
{
protected:
    // Names in the folder, sorted; a temporary file is one of them.
    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    nlohmann::json figuresOf(const std::string& command) const
    {
        const auto outcome = here(command + " --json");
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return nlohmann::json::parse(outcome.out);
    }

    std::vector<std::string> contents() const
    {
        std::vector<std::string> all;
        for (const auto& name : files())
            all.push_back(name + readFile(folder / name));
        return all;
    }
};

// A scene of its own, to be edited.
const std::string movingBall =
    "printf '[camera]\\neye = [0, 0, 5]\\n[material.m]\\ncolour = [1, 0, 0]\\nemission = [1, 0, 0]\\n"
    "[[sphere]]\\nname = \"ball\"\\ncentre = [0, 0, 0]\\nradius = 1\\nmaterial = \"m\"\\n"
    "[[animate]]\\npath = \"ball.centre\"\\ntimes = [0, 4]\\nvalues = [[-2, 0, 0], [2, 0, 0]]\\n' "
    ">ball.toml; ";

} // namespace

TEST_F(FramesCommand, Frames_AreNumberedByFourDigits_AndBothEndsAreDrawn)
{
    const auto outcome = here("dioptre render orrery --frames 8:10" + smallFrames + "-o turn.png");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(files(), (std::vector<std::string>{"turn.0008.png", "turn.0009.png", "turn.0010.png"}));
}

TEST_F(FramesCommand, ARunOfHashes_StandsForTheNumber)
{
    ASSERT_EQ(here("dioptre render orrery --frames 7:11:4" + smallFrames + "-o t_##_a.exr").code, 0);
    EXPECT_EQ(files(), (std::vector<std::string>{"t_07_a.exr", "t_11_a.exr"}));
}

TEST_F(FramesCommand, TheLargestNumber_SetsTheWidthOfAll)
{
    ASSERT_EQ(here("dioptre render orrery --frames 2:10002:10000" + smallFrames + "-o t.png").code, 0);
    EXPECT_EQ(files(), (std::vector<std::string>{"t.00002.png", "t.10002.png"}));
}

TEST_F(FramesCommand, WithoutOutput_FramesAreNamedAfterTheScene)
{
    ASSERT_EQ(here("dioptre render orrery --frames 0:0" + smallFrames).code, 0);
    EXPECT_EQ(files(), (std::vector<std::string>{"orrery.0000.png"}));
}

TEST_F(FramesCommand, ATime_IsTheStartAndTheNumberOverTheRate_NeverASum)
{
    const auto figures =
        figuresOf("dioptre render orrery --frames 1:15:7 --fps 10 --time 0.5" + smallFrames + "-o t.png");
    ASSERT_EQ(figures["frames"].size(), 3U);
    const double expected[] = {0.5 + 1 / 10.0, 0.5 + 8 / 10.0, 0.5 + 15 / 10.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(figures["frames"][i]["time_s"], expected[i]);
        EXPECT_EQ(figures["frames"][i]["frame"], 1 + 7 * i);
        const auto file = folder / std::string(figures["frames"][i]["output"]);
        EXPECT_EQ(std::stod(readSettings(file).at("dioptre.time")), expected[i]);
    }
    EXPECT_EQ(figures["drawn"], 3);
    EXPECT_EQ(figures["output"], "t.####.png");
}

TEST_F(FramesCommand, TheRate_Is25WhereNoneIsGiven)
{
    EXPECT_EQ(
        figuresOf("dioptre render orrery --frames 7:7" + smallFrames + "-o t.png")["frames"][0]["time_s"],
        7 / 25.0);
}

TEST_F(FramesCommand, AFrame_IsTheStillOfItsTime)
{
    ASSERT_EQ(here("dioptre render orrery --frames 0:2 --fps 1" + smallFrames +
                   "-o t.exr && dioptre render orrery --time 2" + smallFrames + "-o still.exr")
                  .code,
              0);
    EXPECT_EQ(readPicture(folder / "t.0002.exr").floats, readPicture(folder / "still.exr").floats);
    EXPECT_NE(readPicture(folder / "t.0001.exr").floats, readPicture(folder / "still.exr").floats);
}

TEST_F(FramesCommand, OfTheReferenceAndOfViews_AreThoseStills)
{
    for (const std::string how : {"--reference", "--view depth"}) {
        ASSERT_EQ(here("dioptre render orrery --frames 0:1 --fps 1 " + how + smallFrames +
                       "-o t.exr && dioptre render orrery --time 1 " + how + smallFrames + "-o still.exr")
                      .code,
                  0);
        EXPECT_EQ(readPicture(folder / "t.0001.exr").floats, readPicture(folder / "still.exr").floats) << how;
    }
}

TEST_F(FramesCommand, OfAPlainShader_AreFedTheTime)
{
    ASSERT_EQ(
        here("printf 'uniform float u_time;\\nout vec4 o;\\nvoid main()\\n{\\n    o = vec4(u_time, 0.0, 0.0, "
             "1.0);\\n}\\n' >p.frag && dioptre render p.frag --frames 0:4:2 --fps 8 --size 4x2 -o p.exr")
            .code,
        0);
    EXPECT_EQ(readPicture(folder / "p.0000.exr").floats[0], 0.0F);
    EXPECT_EQ(readPicture(folder / "p.0004.exr").floats[0], 0.5F);
}

TEST_F(FramesCommand, Resume_DrawsWhatIsMissingOrCutShort_AndEndsWithTheSameBytes)
{
    for (const std::string kind : {"png", "hdr", "exr"}) {
        const std::string command = "dioptre render orrery --frames 0:4" + smallFrames + "-o t." + kind;
        ASSERT_EQ(here(command).code, 0);
        const auto whole = contents();
        std::filesystem::remove(folder / ("t.0001." + kind));
        const auto cut = folder / ("t.0003." + kind);
        std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 20);
        const auto figures = figuresOf(command + " --resume");
        EXPECT_EQ(figures["drawn"], 2);
        EXPECT_EQ(figures["kept"], 3);
        EXPECT_TRUE(figures["frames"][0]["kept"]);
        EXPECT_FALSE(figures["frames"][1]["kept"]);
        EXPECT_FALSE(figures["frames"][3]["kept"]);
        EXPECT_EQ(contents(), whole);
        EXPECT_EQ(figuresOf(command + " --resume")["drawn"], 0);
    }
}

TEST_F(FramesCommand, Resume_DrawsAnewWhatAnySettingChanges)
{
    const std::string command = "dioptre render ball.toml --frames 0:1 --size 32x18 -o t.png --resume ";
    ASSERT_EQ(here(movingBall + command + "--spp 1").code, 0);
    EXPECT_EQ(figuresOf(command + "--spp 1")["kept"], 2);
    for (const std::string change :
         {"--spp 2", "--spp 1 --fps 24", "--spp 1 --time 1", "--spp 1 --set ball.radius=0.5",
          "--spp 1 --budget 3", "--spp 1 --view normal", "--spp 1 --reference", "--spp 1 --exposure 0",
          "--spp 1 --curve filmic"}) {
        const auto figures = figuresOf(command + change);
        // Frame 0 is at the same time at any rate.
        EXPECT_EQ(figures["drawn"], change == "--spp 1 --fps 24" ? 1 : 2) << change;
        ASSERT_EQ(here(command + "--spp 1").code, 0); // back again
    }
    ASSERT_EQ(here("sed -i 's/radius = 1/radius = 2/' ball.toml").code, 0);
    EXPECT_EQ(figuresOf(command + "--spp 1")["drawn"], 2);
}

TEST_F(FramesCommand, Resume_DrawsAnewWhereAPictureThatIsReadChanged)
{
    const std::string shader = "printf 'out vec4 o;\\nvoid main()\\n{\\n    o = vec4(%s);\\n}\\n' ";
    const std::string paint = " >p.frag && dioptre render p.frag --size 8x4 -o p.png";
    const std::string command = "dioptre render ball.toml --frames 0:1" + smallFrames + "-o t.png --resume";
    ASSERT_EQ(here(movingBall + shader + "0.5" + paint +
                   " && sed -i 's/^colour.*/image = \"p.png\"\\nambient = [1, 1, 1]/' ball.toml && "
                   "printf '[[light]]\\nkind = \"ambient\"\\nambient = [1, 1, 1]\\n' >>ball.toml && " +
                   command)
                  .code,
              0);
    EXPECT_EQ(figuresOf(command)["kept"], 2);
    ASSERT_EQ(here(shader + "0.6" + paint).code, 0);
    EXPECT_EQ(figuresOf(command)["drawn"], 2);
}

TEST_F(FramesCommand, Stopped_LeavesWholeFramesOnly_AndResumedGivesTheSameBytes)
{
    const std::string command = "render orrery --frames 0:400 --size 160x90 --spp 8 -o t.png";
    const auto stopped = here("{ \"$PROGRAM\" " + command +
                              " & pid=$!; while kill -0 $pid && [ ! -e t.0002.png ]; do sleep 0.01; done; "
                              "kill -TERM $pid; wait $pid; }");
    EXPECT_EQ(stopped.code, 128 + 15) << stopped.error;
    EXPECT_NE(stopped.error.find("--resume"), std::string::npos) << stopped.error;
    const auto left = files();
    EXPECT_LT(left.size(), 401U);
    for (const auto& name : left)
        EXPECT_NO_THROW(readPicture(folder / name)) << name;
    const std::string few = "dioptre render orrery --frames 0:5 --size 160x90 --spp 8 -o ";
    ASSERT_EQ(here("mkdir whole && " + few + "whole/t.png && " + few + "t.png --resume").code, 0);
    for (const std::string number : {"0000", "0002", "0005"})
        EXPECT_EQ(readFile(folder / ("t." + number + ".png")),
                  readFile(folder / "whole" / ("t." + number + ".png")));
}

TEST_F(FramesCommand, WhatCannotBeWritten_IsRefusedFirst)
{
    const auto outcome = here("dioptre render orrery --frames 0:3" + smallFrames + "-o nowhere/t.png");
    EXPECT_EQ(outcome.code, 73);
    EXPECT_NE(outcome.error.find("nowhere"), std::string::npos);
}

// Also for root, who may write everywhere.
TEST_F(FramesCommand, WhatCannotBeWrittenInTheMiddle_LeavesTheEarlierFramesWhole)
{
    const auto outcome =
        here("mkdir t.0002.png && dioptre render orrery --frames 0:4" + smallFrames + "-o t.png");
    EXPECT_EQ(outcome.code, 73);
    EXPECT_NE(outcome.error.find("t.0002.png"), std::string::npos);
    EXPECT_EQ(files(), (std::vector<std::string>{"t.0000.png", "t.0001.png", "t.0002.png"}));
    EXPECT_NO_THROW(readPicture(folder / "t.0001.png"));
}

TEST_F(FramesCommand, WhatMakesNoSense_IsRefusedByItsName)
{
    const std::pair<std::string, std::string> cases[] = {
        {"--frames 5 -o t.png", "5"},
        {"--frames 5:2 -o t.png", "after"},
        {"--frames 0:9:0 -o t.png", "step"},
        {"--frames -3:9 -o t.png", "-3"},
        {"--frames 0:9:2:1 -o t.png", "FIRST:LAST"},
        {"--frames a:9 -o t.png", "'a'"},
        {"--frames 0:99999999 -o t.png", "9999999"},
        {"--frames 0:99999999999999999999 -o t.png", "99999999999999999999"},
        {"--frames 0:9 --fps 0 -o t.png", "--fps"},
        {"--frames 0:9 --fps -25 -o t.png", "--fps"},
        {"--frames 0:9 --fps inf -o t.png", "--fps"},
        {"--frames 0:9 --fps 1e-300 -o t.png", "frame 9"},
        {"--frames 0:9 -o t_##_##.png", "####"},
        {"--frames 0:9 -o '##/t.png'", "one folder"},
        {"--frames 0:9 -o t_%04d.png", "####"},
        {"--frames 0:9 -o t.gif", ".gif"},
        {"--frames 0:9 --why -o t.png", "--why"},
        {"--frames 0:9 --shader a.frag -o t.png", "--shader"},
        {"--frames 0:9 --resume -o t.mp4", "--resume"},
        {"--frames 0:9 -o t##.mp4", "#"},
        {"--fps 9 -o t.png", "--frames"},
        {"--resume -o t.png", "--frames"},
        {"-o t.mp4", ".png"},
    };
    for (const auto& [options, says] : cases) {
        const auto outcome = here("dioptre render orrery " + options);
        EXPECT_EQ(outcome.code, 2) << options;
        EXPECT_NE(outcome.error.find(says), std::string::npos) << options << ": " << outcome.error;
    }
    EXPECT_TRUE(files().empty());
}
