// Frames through a pipe to ffmpeg, in whose place a script of its name stands.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace dioptre;

namespace
{

class VideoCommand : public test::InAFolder
{
protected:
    // `script` in place of ffmpeg: $last is the file that it is to write.
    void putFfmpeg(const std::string& script) const
    {
        std::filesystem::create_directory(folder / "bin");
        std::ofstream(folder / "bin" / "ffmpeg") << "#!/bin/sh\nfor last; do :; done\nlast=${last#file:}\n"
                                                 << script << "\n";
        std::filesystem::permissions(folder / "bin" / "ffmpeg", std::filesystem::perms::owner_all);
    }

    test::Outcome film(const std::string& options) const
    {
        return here("PATH=\"$PWD/bin:$PATH\" && dioptre render orrery --size 32x18 --spp 1 " + options);
    }

    // Nothing but the script, what it noted, and these.
    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().filename() != "bin" && entry.path().filename() != "noted")
                names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
};

// The bytes of a PNG's pixels from the top down, less alpha.
std::string rgbOf(const std::filesystem::path& png)
{
    const Picture picture = readPicture(png);
    const auto bytes = topDownBytes(picture, PngForm{.encode = false});
    return {bytes.begin(), bytes.end()};
}

} // namespace

TEST_F(VideoCommand, Ffmpeg_GetsTheBytesOfEveryFrameInOrder)
{
    putFfmpeg("echo \"$@\" >noted; cat >\"$last\"");
    const auto outcome = film("--frames 0:6:3 --fps 12 --json -o t.mp4");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    ASSERT_EQ(film("--frames 0:6:3 --fps 12 -o t.png").code, 0);
    EXPECT_EQ(readFile(folder / "t.mp4"),
              rgbOf(folder / "t.0000.png") + rgbOf(folder / "t.0003.png") + rgbOf(folder / "t.0006.png"));
    const auto words = readFile(folder / "noted");
    for (const char* word :
         {"-video_size 32x18", "-framerate 12/3", "rgb24", "libx264", "yuv420p", "-crf 18"})
        EXPECT_NE(words.find(word), std::string::npos) << words;
    const auto figures = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(figures["output"], "t.mp4");
    EXPECT_EQ(figures["frames"][2]["time_s"], 0.5);
}

TEST_F(VideoCommand, OfAView_HasTheBytesOfItsPictures)
{
    putFfmpeg("cat >\"$last\"");
    ASSERT_EQ(
        film("--frames 1:1 --view normal -o t.webm && dioptre render orrery --size 32x18 --spp 1 --frames "
             "1:1 --view normal -o t.png")
            .code,
        0);
    EXPECT_EQ(readFile(folder / "t.webm"), rgbOf(folder / "t.0001.png"));
}

TEST_F(VideoCommand, WithoutFfmpeg_SaysSo)
{
    const auto outcome = here("PATH=\"$PWD\" && dioptre render orrery --size 32x18 --frames 0:3 -o t.mp4");
    EXPECT_EQ(outcome.code, 69);
    EXPECT_NE(outcome.error.find("ffmpeg"), std::string::npos);
    EXPECT_TRUE(files().empty());
}

TEST_F(VideoCommand, AFailingFfmpeg_IsQuotedAndLeavesNoVideo)
{
    // At once, after all, and by a signal.
    for (const std::string script :
         {"echo 'no such codec' >&2; exit 8", "cat >\"$last\"; echo 'no such codec' >&2; exit 8",
          "cat >\"$last\"; echo 'no such codec' >&2; kill -9 $$"}) {
        putFfmpeg(script);
        const auto outcome = film("--frames 0:60 -o t.mkv");
        EXPECT_EQ(outcome.code, 73) << script;
        EXPECT_NE(outcome.error.find("no such codec"), std::string::npos) << outcome.error;
        EXPECT_TRUE(files().empty()) << script;
    }
}

TEST_F(VideoCommand, ThatWasThere_StaysWhereTheNewOneFails)
{
    putFfmpeg("cat >/dev/null; exit 1");
    ASSERT_EQ(here("echo old >t.mp4").code, 0);
    EXPECT_EQ(film("--frames 0:3 -o t.mp4").code, 73);
    EXPECT_EQ(readFile(folder / "t.mp4"), "old\n");
}

TEST_F(VideoCommand, OfOddSides_IsRefusedWithAnEvenSize)
{
    const auto outcome = here("dioptre render orrery --size 33x17 --frames 0:3 -o t.mp4");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.error.find("--size 34x18"), std::string::npos) << outcome.error;
}

TEST_F(VideoCommand, Stopped_LeavesNothing)
{
    // It stops its parent after the first bytes and would go on for long.
    putFfmpeg("head -c 100 >\"$last\"; kill -TERM $PPID; sleep 1000");
    const auto outcome = film("--frames 0:9999 -o t.mp4");
    EXPECT_EQ(outcome.code, 128 + 15) << outcome.error;
    EXPECT_TRUE(files().empty());
}
