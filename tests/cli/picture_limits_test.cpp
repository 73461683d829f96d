// Pictures that lie or are too large are refused before memory is taken for what they claim, whatever they
// are wanted for.
#include "support/forged_pictures.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

using namespace dioptre::test;

namespace
{

struct Forged {
    std::string name;
    std::string file;
    std::string bytes;
    std::string says;
};

void PrintTo(const Forged& forged, std::ostream* stream)
{
    *stream << forged.name;
}

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();
constexpr Window tiny{0, 0, 3, 3};
constexpr Window billion{0, 0, 1'000'000'000, 1'000'000'000};
const std::string texelLimit = "at most 16384 texels on a side and 134217728 in all, as 16384x8192 has";

// An EXR's name ends in .exr: OpenEXR is asked by content, and the message names the file.
const std::vector<Forged>& forgedPictures()
{
    static const std::vector<Forged> pictures = {
        {"PngOf60000", "b.png", forgedPng(60000, 60000), texelLimit},
        {"PngWithoutWidth", "b.png", forgedPng(0, 5), "width"},
        {"PngOf31Bits", "b.png", forgedPng(highest, highest), texelLimit},
        {"PngOf32Bits", "b.png", forgedPng(0xFFFFFFFFU, 5), "width"},
        {"PngOfAFewBytes", "b.png", forgedPng(16384, 8192), "takes 130055 bytes or more"},
        {"PngOfAFewDeepBytes", "b.png", forgedPng(16384, 8192, 16), "takes 260111 bytes or more"},
        {"PngCutShort", "b.png", blackPng(640, 480).substr(0, 100), "broken or cut short"},
        {"PngBomb", "b.png", blackPng(16384, 16384), texelLimit},
        {"PngWithABombOfText", "b.png", pngWithText(std::size_t{72} << 20), "broken"},
        {"JpegOf65500", "b.jpg", forgedJpeg(65500, 65500), texelLimit},
        {"JpegOfAFewBytes", "b.jpg", forgedJpeg(16384, 8192), "takes 65536 bytes or more"},
        {"JpegWithoutHeight", "b.jpg", forgedJpeg(640, 0), "header"},
        {"JpegCutShort", "b.jpg", forgedJpeg(640, 480), "broken or cut short"},
        {"RadianceOf100000", "b.hdr", forgedRadiance("-Y 100000 +X 100000"), texelLimit},
        {"RadianceOfManyDigits", "b.hdr", forgedRadiance("-Y 99999999999999999999 +X 8"), texelLimit},
        {"RadianceBelowZero", "b.hdr", forgedRadiance("-Y -5 +X 8"), "8x-5"},
        {"RadianceOfAFewBytes", "b.hdr", forgedRadiance("-Y 8192 +X 16384"), "takes 65536 bytes or more"},
        {"ExrOfABillion", "b.exr", forgedExr(billion, billion), texelLimit},
        {"ExrOnADisplayOfABillion", "b.exr", forgedExr(tiny, billion), texelLimit},
        {"ExrOfABillionOnASmallDisplay", "b.exr", forgedExr(billion, tiny), texelLimit},
        {"ExrOfAllNumbers", "b.exr", forgedExr({lowest, lowest, highest, highest}, tiny), texelLimit},
        {"ExrAtTheHighestNumbers", "b.exr",
         forgedExr({highest - 3, highest - 3, highest, highest},
                   {highest - 3, highest - 3, highest, highest}),
         "broken"},
        {"ExrAtTheLowestNumbers", "b.exr",
         forgedExr({lowest, lowest, lowest + 3, lowest + 3}, {lowest, lowest, lowest + 3, lowest + 3}),
         "broken"},
        {"ExrWithoutWidth", "b.exr", forgedExr({3, 0, 0, 3}, tiny), "-2x4"},
        {"ExrOfAFewBytes", "b.exr", forgedExr({0, 0, 16383, 8191}, {0, 0, 16383, 8191}), "broken"},
        {"ExrWithALongAttribute", "b.exr",
         forgedExr(tiny, tiny, exrAttribute("owner", "string", "me", highest)),
         "its attribute owner is longer than the file"},
        {"ExrOfManyTiles", "b.exr",
         forgedExr(
             {0, 0, 16383, 8191}, {0, 0, 16383, 8191},
             exrAttribute("tiles", "tiledesc", littleEndian(1) + littleEndian(1) + std::string(1, '\0'), 9)),
         "more chunks than it could list"},
        {"ExrOfManyChunks", "b.exr",
         forgedExr(tiny, tiny, exrAttribute("chunkCount", "int", littleEndian(highest), 4)),
         "more chunks than it could list"},
        {"ExrOfMoreNumbersThanItCouldHold", "b.exr",
         forgedExr({0, 0, 16383, 8191}, {0, 0, 16383, 8191},
                   exrAttribute("compression", "compression", "\x09", 1)), // DWA, 256 rows a chunk
         "takes 12192 bytes or more"},
        {"ExrOfALargeTile", "b.exr",
         forgedExr(tiny, tiny,
                   exrAttribute("tiles", "tiledesc",
                                littleEndian(0xFF0008) + littleEndian(8) + std::string(1, '\0'), 9)),
         "takes 12145 bytes or more"},
        {"ExrWithASmallBox", "b.exr", forgedExr(tiny, tiny, exrAttribute("box", "box2i", "four", 4)),
         "its attribute box is of another size than box2i"},
        {"ExrWithChannelsThatEndEarly", "b.exr",
         forgedExr(tiny, tiny, exrAttribute("more", "chlist", std::string(5, '\0'), 5)),
         "its channels end elsewhere than they say"},
        {"ExrWithANameWithoutEnd", "b.exr",
         forgedExr(tiny, tiny, exrAttribute(std::string(256, 'n'), "int", "four", 4)),
         "a name in its header does not end"},
        {"ExrOfHalfAHeader", "b.exr", forgedExr(tiny, tiny).substr(0, 150), "header does not end"}};
    return pictures;
}

class ForgedPicture : public InAFolder, public testing::WithParamInterface<Forged>
{
protected:
    void expectRefused(const std::string& input)
    {
        const auto& forged = GetParam();
        const auto outcome = here("dioptre render " + input + " --size 8x4 -o a.png");
        EXPECT_EQ(outcome.code, 65) << outcome.error;
        EXPECT_NE(outcome.error.find(forged.file + ": "), std::string::npos) << outcome.error;
        EXPECT_NE(outcome.error.find(forged.says), std::string::npos) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
        EXPECT_LT(outcome.peak_mib, most_mib);
    }

    // Half of what the smallest of these would take. This process, whose peak is measured too, stays under
    // it.
    static constexpr double most_mib = 512.0;
};

INSTANTIATE_TEST_SUITE_P(Pictures, ForgedPicture, testing::ValuesIn(forgedPictures()),
                         [](const auto& info) { return info.param.name; });

} // namespace

TEST_P(ForgedPicture, AsChannel_Image_Sky_IsRefusedBeforeItTakesMemory)
{
    const auto& forged = GetParam();
    std::ofstream(folder / forged.file, std::ios::binary) << forged.bytes;
    std::ofstream(folder / "p.frag")
        << "void mainImage(out vec4 o, in vec2 p)\n{\n    o = texture(iChannel0, p);\n}\n";
    std::ofstream(folder / "sky.toml") << "[sky]\nimage = \"" << forged.file << "\"\n";
    std::ofstream(folder / "ball.toml")
        << "[camera]\neye = [0, 0, 5]\n[material.m]\nimage = \"" << forged.file
        << "\"\n[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n"
           "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
    expectRefused("p.frag --channel0 " + forged.file);
    expectRefused("sky.toml --spp 1");
    expectRefused("ball.toml --spp 1");
}

using ForgedPart = InAFolder;

// So many numbers that no whole number of the machine counts them.
TEST_F(ForgedPart, OfAnExrOfAllNumbers_IsRefused)
{
    std::ofstream(folder / "b.exr", std::ios::binary)
        << forgedExr({lowest, lowest, highest, highest}, {lowest, lowest, highest, highest});
    const auto outcome = here("dioptre join b.exr b.exr -o a.exr");
    EXPECT_EQ(outcome.code, 65) << outcome.error;
    EXPECT_NE(outcome.error.find("b.exr"), std::string::npos) << outcome.error;
}

TEST_F(ForgedPart, OfAnExr_IsRefusedBeforeItTakesMemory)
{
    std::ofstream(folder / "b.exr", std::ios::binary)
        << forgedExr(tiny, tiny, exrAttribute("owner", "string", "me", highest));
    const auto outcome = here("dioptre join b.exr b.exr -o a.exr");
    EXPECT_EQ(outcome.code, 65) << outcome.error;
    EXPECT_NE(outcome.error.find("its attribute owner is longer than the file"), std::string::npos)
        << outcome.error;
}

using LargePicture = InAFolder;

// And so the memory is seen where it is taken.
TEST_F(LargePicture, ThatIsWhole_TakesItsMemory)
{
    std::ofstream(folder / "b.png", std::ios::binary) << blackPng(8192, 4096);
    std::ofstream(folder / "p.frag")
        << "void mainImage(out vec4 o, in vec2 p)\n{\n    o = texture(iChannel0, p);\n}\n";
    const auto outcome = here("dioptre render p.frag --channel0 'b.png?filter=nearest' --size 8x4 -o a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_GT(outcome.peak_mib, 4.0 * 8192.0 * 4096.0 / 1048576.0 + 128.0); // the picture and its texture
}
