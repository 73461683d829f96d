// Where there is no room the program says so, ends with 73, and leaves what is whole: nothing else.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// What room there is: a disk of 64 KiB, or files that may grow to no more, where none can be mounted.
struct Room {
    std::string name;
    std::string before; // the command, in the folder `room`
    std::string after;
};

void PrintTo(const Room& room, std::ostream* stream)
{
    *stream << room.name;
}

const std::string mountIt = "unshare --user --map-root-user --mount sh -c '"
                            "mount -t tmpfs -o size=64k none room && cd room && ";
// The disk goes with the program: what lies on it is told before that.
const Room disk{"Disk", mountIt, "; code=$?; cp -a . ../left; exit $code'"};
// Blocks of 512 bytes. A signal that is ignored becomes EFBIG.
const Room limit{"Limit", "(trap '' XFSZ; ulimit -f 128; cd room && ",
                 ")\ncode=$?; mv room left; mkdir room; exit $code"};

// Black until frame 2, which is noise and takes more than 64 KiB in every kind of file.
const char* const noise = R"(void mainImage(out vec4 o, in vec2 p)
{
    uvec2 q = uvec2(p);
    uint h = (q.x * 1664525u + q.y * 22695477u + 1013904223u) * 747796405u;
    h = ((h >> 16) ^ h) * 2246822519u;
    h = (h >> 13) ^ h;
    o = iFrame < 2 ? vec4(0.0) : vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, 255u) / 255.0;
}
)";

class FullDisk : public InAFolder, public testing::WithParamInterface<Room>
{
protected:
    FullDisk()
    {
        std::filesystem::create_directory(folder / "room");
        std::ofstream(folder / "noise.frag") << noise;
        std::ofstream(folder / "long.frag")
            << "void mainImage(out vec4 o, in vec2 p)\n{\n    o = vec4(1.0);\n}\n"
            << [] {
                   std::string text;
                   for (int i = 0; i < 10000; ++i)
                       text += "#define NAME_" + std::to_string(i) + " 1\n";
                   return text;
               }();
    }

    void SetUp() override
    {
        if (GetParam().name == disk.name && here(mountIt + "true'").code != 0)
            GTEST_SKIP() << "no disk can be mounted here";
    }

    Outcome renderWithin(const std::string& options)
    {
        // Mesa's own files must not meet the limit first.
        return here("export MESA_SHADER_CACHE_DISABLE=true MESA_GLSL_CACHE_DISABLE=true; " +
                    GetParam().before + "\"$PROGRAM\" render " + options + GetParam().after);
    }

    std::set<std::string> left() const
    {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "left"))
            names.insert(entry.path().filename().string());
        return names;
    }

    void expectNoRoom(const Outcome& outcome, const std::string& file)
    {
        EXPECT_EQ(outcome.code, 73) << outcome.error;
        EXPECT_NE(outcome.error.find("dioptre: " + file + ": "), std::string::npos) << outcome.error;
        EXPECT_NE(outcome.error.find("-o"), std::string::npos) << outcome.error;
    }
};

INSTANTIATE_TEST_SUITE_P(Rooms, FullDisk, testing::Values(disk, limit),
                         [](const auto& info) { return info.param.name; });

} // namespace

TEST_P(FullDisk, Pictures_AreNotLeftInPart)
{
    const std::vector<std::string> cases = {"a.png", "a.png --depth 16", "a.hdr", "a.exr", "a.exr --half"};
    for (const auto& output : cases) {
        SCOPED_TRACE(output);
        expectNoRoom(renderWithin("../noise.frag --size 256x256 --time 1 -o " + output), output.substr(0, 5));
        EXPECT_EQ(left(), std::set<std::string>{});
        std::filesystem::remove_all(folder / "left");
    }
}

TEST_P(FullDisk, PictureThatWasThere_StaysWhole)
{
    const auto outcome = renderWithin("../noise.frag --size 256x256 -o a.png && \"$PROGRAM\" render "
                                      "../noise.frag --size 256x256 --time 1 -o a.png");
    expectNoRoom(outcome, "a.png");
    EXPECT_EQ(left(), std::set<std::string>{"a.png"});
    const auto picture = readPicture(folder / "left" / "a.png");
    EXPECT_EQ(std::ranges::count(picture.bytes, 0), 3 * 256 * 256); // black, and opaque
}

TEST_P(FullDisk, FramesBeforeIt_StayWhole)
{
    for (const std::string kind : {".png", ".hdr", ".exr"}) {
        SCOPED_TRACE(kind);
        const auto outcome = renderWithin("../noise.frag --size 256x256 --frames 0:3 -o a" + kind);
        expectNoRoom(outcome, "a.0002" + kind);
        EXPECT_EQ(left(), (std::set<std::string>{"a.0000" + kind, "a.0001" + kind}));
        for (const auto& name : left())
            EXPECT_EQ(readPicture(folder / "left" / name).width, 256);
        std::filesystem::remove_all(folder / "left");
    }
}

TEST_P(FullDisk, Shader_IsNotLeftInPart)
{
    const auto outcome = renderWithin("../long.frag --size 16x16 -o a.png --shader b.frag");
    expectNoRoom(outcome, "b.frag");
    for (const auto& name : left()) {
        EXPECT_EQ(name, "a.png"); // it is written first: whole or not at all
        EXPECT_EQ(readPicture(folder / "left" / name).width, 16);
    }
}

using FullStandardOutput = InAFolder;

TEST_F(FullStandardOutput, Figures_EndWith73AndAWholePicture)
{
    std::ofstream(folder / "p.frag") << noise;
    for (const std::string options : {"--json", "--json --why", "--frames 0:1 --json"})
        for (const std::string where : {">/dev/full", ">&-"}) {
            SCOPED_TRACE(options + where);
            const auto outcome = here("dioptre render p.frag --size 16x16 -o a.png " + options + " " + where);
            EXPECT_EQ(outcome.code, 73);
            EXPECT_NE(outcome.error.find("standard output takes no more"), std::string::npos)
                << outcome.error;
            EXPECT_EQ(outcome.error.find("unexpected"), std::string::npos) << outcome.error;
            for (const auto& entry : std::filesystem::directory_iterator(folder))
                if (entry.path().extension() == ".png")
                    EXPECT_EQ(readPicture(entry.path()).width, 16);
                else
                    EXPECT_EQ(entry.path().filename(), "p.frag");
        }
}

// What is longer than a stream's buffer fails before the program's end.
TEST_F(FullStandardOutput, LongReports_EndWith73)
{
    const auto outcome = here("dioptre render still_life --size 16x9 --spp 1 --json --why -o a.png >&-");
    EXPECT_EQ(outcome.code, 73);
    EXPECT_NE(outcome.error.find("standard output takes no more"), std::string::npos) << outcome.error;
}

TEST_F(FullStandardOutput, FullStandardError_EndsWith73)
{
    std::ofstream(folder / "p.frag") << noise;
    EXPECT_EQ(here("dioptre render p.frag --size 16x16 -o a.png 2>/dev/full").code, 73);
    EXPECT_EQ(here("dioptre render p.frag --size 16x16 -o b.png 2>&-").code, 0); // closed: it is not wanted
    EXPECT_EQ(readPicture(folder / "b.png").width, 16);
}
