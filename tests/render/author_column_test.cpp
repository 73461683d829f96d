#include "render/author_column.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

// Of a message of Mesa's at `column` of the last line.
int columnIn(const std::string& text, int column)
{
    const SourceText source = linesOf(text, "a.frag");
    return authorColumn({static_cast<int>(source.size()), column, "", true}, source, source.size() - 1);
}

} // namespace

// The columns are those of Mesa 22.3.6 for the undeclared foo.
TEST(AuthorColumn, RunsOfBlanksAndComments_CountAsWritten)
{
    EXPECT_EQ(columnIn("foo;", 1), 1);
    EXPECT_EQ(columnIn("        vec4 q = foo;", 11), 18);
    EXPECT_EQ(columnIn("\t\tvec4 r = foo;", 11), 12);
    EXPECT_EQ(columnIn("/* a comment */ vec4 s = foo;", 11), 26);
    EXPECT_EQ(columnIn("  float    u    =    foo;", 12), 22);
    EXPECT_EQ(columnIn("vec4 s =/**/foo;", 10), 13);
}

TEST(AuthorColumn, FirstLineBehindAByteOrderMark_CountsWithoutIt)
{
    EXPECT_EQ(columnIn("\xEF\xBB\xBF"
                       "foo x;",
                       1),
              1);
}

TEST(AuthorColumn, BehindAMacro_IsUnknownAndBeforeOneIsNot)
{
    EXPECT_EQ(columnIn("#define M(x) ((x) + (x))\n    float t = M(1.0) + foo;", 26), 0);
    EXPECT_EQ(columnIn("#define M(x) ((x) + (x))\n    float t = foo + M(1.0);", 12), 15);
}

TEST(AuthorColumn, BeyondTheLineOrWithinAComment_IsUnknown)
{
    EXPECT_EQ(columnIn("foo;", 5), 0);
    EXPECT_EQ(columnIn("foo; // bar", 9), 0);
    EXPECT_EQ(columnIn("/* a\n b", 2), 0);
    EXPECT_EQ(columnIn("foo;", 0), 0);
}

TEST(AuthorColumn, OfDriversThatCountInTheSource_IsKept)
{
    const SourceText source = linesOf("      foo;", "a.frag");
    EXPECT_EQ(authorColumn({1, 7, "error: x"}, source, 0), 7);
}
