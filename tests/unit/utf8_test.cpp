#include "base/utf8.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

std::u32string decoded(std::string_view text)
{
    std::u32string codes;
    for (std::size_t at = 0; at < text.size();)
        codes.push_back(nextCodePoint(text, at));
    return codes;
}

TEST(Utf8, EachLength_AtItsFirstAndLast_IsDecoded)
{
    EXPECT_EQ(decoded("a\x7F"), U"a\u007F");
    EXPECT_EQ(decoded("\xC2\x80\xDF\xBF"), U"\u0080\u07FF");
    EXPECT_EQ(decoded("\xE0\xA0\x80\xEF\xBF\xBF"), U"\u0800\uFFFF");
    EXPECT_EQ(decoded("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"), U"\U00010000\U0010FFFF");
    EXPECT_EQ(decoded("1 – …"), U"1 \u2013 \u2026");
}

TEST(Utf8, BytesOfNoCodePoint_AreReplacedOneByOne)
{
    EXPECT_EQ(decoded("a\x80z"), U"a\uFFFDz");                 // follows nothing
    EXPECT_EQ(decoded("a\xC3z"), U"a\uFFFDz");                 // followed by nothing
    EXPECT_EQ(decoded("a\xE2\x80"), U"a\uFFFD\uFFFD");         // cut short
    EXPECT_EQ(decoded("\xC0\x80"), U"\uFFFD\uFFFD");           // longer than need be
    EXPECT_EQ(decoded("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD"); // half of a pair
    EXPECT_EQ(decoded("\xF4\x90\x80\x80").front(), U'\uFFFD'); // beyond the last
    EXPECT_EQ(decoded("\xF8\x88\x80\x80\x80").size(), 5U);     // no lead byte
    EXPECT_EQ(decoded(std::string_view("\0", 1)).front(), U'\0');
}

} // namespace
} // namespace dioptre
