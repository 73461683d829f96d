#include "base/error.h"
#include "base/text.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

TEST(Text_ReadPair, WholeNumbersAbove0_AreRead_AndNothingElse)
{
    int first = 0, second = 0;
    EXPECT_TRUE(readPair("2/8", '/', first, second));
    EXPECT_EQ(first, 2);
    EXPECT_EQ(second, 8);
    EXPECT_TRUE(readPair("1000000x1", 'x', first, second));
    for (const char* text : {"", "2", "2/", "/8", "0/8", "2/0", "-2/8", "2/8 ", " 2/8", "2x8", "2/8/3",
                             "1000001/1", "1/99999999999"})
        EXPECT_FALSE(readPair(text, '/', first, second)) << text;
}

TEST(Text_NearestWord, FindsTheWordThatOneSlipAwayIsMeant)
{
    const std::vector<std::string> words{"sphere", "cylinder", "plane", "disk"};
    EXPECT_EQ(nearestWord("spere", words), "sphere");       // a letter left out
    EXPECT_EQ(nearestWord("cyllinder", words), "cylinder"); // one too many
    EXPECT_EQ(nearestWord("palne", words), "plane");        // two neighbours swapped
    EXPECT_EQ(nearestWord("disc", words), "disk");          // one replaced
    EXPECT_EQ(nearestWord("Sphere", words), "sphere");      // case
}

TEST(Text_NearestWord, PrefersTheFewerSlips)
{
    EXPECT_EQ(nearestWord("colours", {"colors", "colour"}), "colors");
    EXPECT_EQ(nearestWord("fov_y_dg", {"fov_x_deg", "fov_y_deg"}), "fov_y_deg");
}

TEST(Text_NearestWord, IsSilentWhenNothingIsNear)
{
    EXPECT_EQ(nearestWord("teapot", {"sphere", "cylinder", "plane"}), "");
    EXPECT_EQ(nearestWord("b", {"a"}), "");
    EXPECT_EQ(nearestWord("word", {}), "");
}

TEST(Text_Join, PutsTheSeparatorOnlyBetween)
{
    EXPECT_EQ(join({}, ", "), "");
    EXPECT_EQ(join({"a"}, ", "), "a");
    EXPECT_EQ(join({"a", "", "c"}, ", "), "a, , c");
}

// Published FNV-1a vectors; the last shows that bytes above 127 count as unsigned (computed by the
// definition).
TEST(Text_Fingerprint, IsFnv1a)
{
    EXPECT_EQ(fingerprint(""), 0xcbf29ce484222325ull);
    EXPECT_EQ(fingerprint("a"), 0xaf63dc4c8601ec8cull);
    EXPECT_EQ(fingerprint("foobar"), 0x85944171f73967e8ull);
    EXPECT_EQ(fingerprint("\xff"), (0xcbf29ce484222325ull ^ 0xffull) * 0x100000001b3ull);
}

std::string messageOf(const SourcePosition& where)
{
    try {
        fail(ExitCode::badInput, where, "what", "mend");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        return error.what();
    }
}

TEST(Error_Fail, NamesAsMuchOfThePlaceAsIsKnown)
{
    EXPECT_EQ(messageOf({"a.toml", 3, 7}), "a.toml:3:7: what: mend");
    EXPECT_EQ(messageOf({"a.toml", 3}), "a.toml:3: what: mend");
    EXPECT_EQ(messageOf({"a.toml"}), "a.toml: what: mend");
    EXPECT_EQ(messageOf({}), "what: mend");
}

} // namespace
} // namespace dioptre
