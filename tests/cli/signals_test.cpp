// Signals that come while a picture is made: the process ends by them and leaves whole files only.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <sys/stat.h>

using namespace dioptre;

namespace
{

class Signals : public test::InAFolder
{
protected:
    Signals()
    {
        std::ofstream(folder / "ball.toml")
            << "[camera]\neye = [0, 0, 5]\n[sky]\ngradient = [[0.1, 0.2, 0.3], [0.6, 0.5, 0.4], [0.7, 0.8, "
               "0.9]]\n"
               "[material.m]\nmirror = 0.5\ncolour = [1, 0, 0]\n"
               "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
    }

    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }

    // Whether the file that is being written holds some of the picture: its head alone is shorter.
    bool isHalfWritten() const
    {
        return std::ranges::any_of(files(), [this](const std::string& name) {
            std::error_code gone;
            return name.starts_with(".dioptre-") && std::filesystem::file_size(folder / name, gone) > 65536 &&
                   !gone;
        });
    }

    bool isThere(const std::string& name) const
    {
        return std::filesystem::exists(folder / name);
    }

    // Frames by name, with a number that a file written anew does not have.
    std::map<std::string, ino_t> framesThere(const std::string& kind) const
    {
        std::map<std::string, ino_t> frames;
        for (const auto& name : files()) {
            struct stat facts {
            };
            if (name.starts_with("t.") && name.ends_with(kind) &&
                ::stat((folder / name).c_str(), &facts) == 0)
                frames[name] = facts.st_ino;
        }
        return frames;
    }

    test::Outcome stopped(const std::string& words, int signal, const std::function<bool(int)>& ready) const
    {
        return test::runAndSignal(folder.string(), words, signal, ready);
    }
};

// Large enough that its first rows are written long before its last are drawn.
const std::string longStill = "render ball.toml --spp 1 --size 20000x12000 -o ";

} // namespace

TEST_F(Signals, InTheMidstOfAStill_EndItAndLeaveTheOldPicture)
{
    const std::pair<std::string, int> cases[] = {{"a.png", SIGINT}, {"a.exr", SIGTERM}, {"a.hdr", SIGHUP}};
    for (const auto& [name, signal] : cases) {
        std::ofstream(folder / name) << "old";
        const auto before = files();
        const auto outcome = stopped(longStill + name, signal, [this](int) { return isHalfWritten(); });
        EXPECT_EQ(outcome.signal, signal) << outcome.code << "\n" << outcome.error;
        EXPECT_NE(outcome.error.find("stopped by a signal"), std::string::npos) << outcome.error;
        EXPECT_EQ(readFile(folder / name), "old");
        EXPECT_EQ(files(), before);
    }
}

TEST_F(Signals, WithoutAnOldPicture_LeaveNone)
{
    const auto before = files();
    const auto outcome = stopped(longStill + "a.png", SIGINT, [this](int) { return isHalfWritten(); });
    EXPECT_EQ(outcome.signal, SIGINT) << outcome.error;
    EXPECT_EQ(files(), before);
}

// 65536 samples a pixel would take hours; the draws of which they are made are short.
TEST_F(Signals, InTheMidstOfDraws_AreHeard)
{
    const auto before = files();
    for (const std::string how : {"", " --reference", " --view depth"}) {
        int looks = 0; // so that draws have begun, as a rule
        const auto outcome =
            stopped("render ball.toml --spp 65536 --size 1280x720 -o a.exr" + how, SIGTERM,
                    [&looks](int process) { return test::hears(process, SIGTERM) && ++looks > 200; });
        EXPECT_EQ(outcome.signal, SIGTERM) << how << "\n" << outcome.error;
        EXPECT_NE(outcome.error.find("stopped by a signal"), std::string::npos) << how << outcome.error;
        EXPECT_EQ(files(), before) << how;
    }
}

TEST_F(Signals, InTheMidstOfAJoin_EndItAndLeaveTheOldPicture)
{
    std::ofstream(folder / "noise.frag") << R"(void mainImage(out vec4 o, in vec2 p)
{
    uvec2 q = uvec2(p);
    uint h = (q.x * 1664525u + q.y * 22695477u + 1013904223u) * 747796405u;
    h = ((h >> 16) ^ h) * 2246822519u;
    o = vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, 255u) / 255.0;
}
)";
    const std::pair<std::string, std::string> cases[] = {{".png", "3000x1280"}, {".exr", "1000x1280"}};
    for (const auto& [kind, size] : cases) {
        const std::string command = "dioptre render noise.frag --size " + size + " --tile ";
        ASSERT_EQ(here(command + "1/2 -o 1" + kind + " && " + command + "2/2 -o 2" + kind).code, 0);
        test::Outcome outcome;
        // A join takes a tenth of a second and more; one that ended before the signal came is begun again.
        for (int tries = 0; tries < 10 && outcome.signal == 0 && outcome.code == 0; ++tries) {
            std::ofstream(folder / ("a" + kind)) << "old";
            const auto before = files();
            outcome = stopped("join 1" + kind + " 2" + kind + " -o a" + kind, SIGINT,
                              [this](int) { return isHalfWritten(); });
            EXPECT_EQ(files(), before);
        }
        EXPECT_EQ(outcome.signal, SIGINT) << kind << outcome.error;
        EXPECT_NE(outcome.error.find("stopped by a signal"), std::string::npos) << outcome.error;
        EXPECT_EQ(readFile(folder / ("a" + kind)), "old");
    }
}

TEST_F(Signals, InTheMidstOfFrames_LoseNone_AndResumedTheyAreThoseOfOneRun)
{
    std::filesystem::create_directory(folder / "whole");
    const std::pair<std::string, std::size_t> cases[] = {{"png", 60}, {"hdr", 30}};
    for (const auto& [kind, count] : cases) {
        const std::string frames = "render orrery --frames 1:" + std::to_string(count) +
                                   " --size 64x36 --spp 32 -o ",
                          files = "t.##." + kind;
        ASSERT_EQ(here("dioptre " + frames + "whole/" + files).code, 0);
        const auto outcome = stopped(frames + files, SIGINT, [&](int) { return isThere("t.12." + kind); });
        EXPECT_EQ(outcome.signal, SIGINT) << outcome.error;
        const auto left = framesThere(kind);
        EXPECT_GE(left.size(), 12U);
        EXPECT_LT(left.size(), count);
        const auto resumed = here("dioptre " + frames + files + " --resume --json");
        ASSERT_EQ(resumed.code, 0) << resumed.error;
        const auto figures = nlohmann::json::parse(resumed.out);
        EXPECT_EQ(figures["kept"], left.size());
        EXPECT_EQ(figures["drawn"], count - left.size());
        const auto now = framesThere(kind);
        EXPECT_EQ(now.size(), count);
        for (const auto& [name, node] : now)
            EXPECT_TRUE(readFile(folder / name) == readFile(folder / "whole" / name)) << name;
        for (const auto& [name, node] : left)
            EXPECT_EQ(now.at(name), node) << name << " was written again";
    }
}
