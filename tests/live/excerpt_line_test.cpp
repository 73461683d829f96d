// Where the caret stands under a line of a source.
#include "live/excerpt_line.h"

#include <gtest/gtest.h>

namespace dioptre::test
{

TEST(ExcerptLine, PlainLine_CaretUnderTheColumn)
{
    EXPECT_EQ(shownLine("float x = y;", 11, ColumnUnit::bytes).caret, 10);
    EXPECT_EQ(shownLine("float x = y;", 1, ColumnUnit::bytes).caret, 0);
}

TEST(ExcerptLine, Tabs_GoToTheNextStop_AndTheCaretWithThem)
{
    const ShownLine line = shownLine("\ta\tb", 4, ColumnUnit::bytes);
    EXPECT_EQ(line.text, "    a   b");
    EXPECT_EQ(line.caret, 8);
    EXPECT_EQ(shownLine("\ta", 1, ColumnUnit::bytes).caret, 0);
}

TEST(ExcerptLine, LettersOfSeveralBytes_CountAsTheirUnitSays)
{
    const std::string text = "\"\xc3\xa4\xe2\x82\xac\" x"; // two letters of 2 and 3 bytes
    EXPECT_EQ(shownLine(text, 9, ColumnUnit::bytes).caret, 5);
    EXPECT_EQ(shownLine(text, 6, ColumnUnit::codePoints).caret, 5);
    EXPECT_EQ(shownLine(text, 3, ColumnUnit::bytes).caret, 1); // within a letter
}

TEST(ExcerptLine, ColumnBehindTheEnd_CaretBehindTheLine)
{
    EXPECT_EQ(shownLine("ab", 3, ColumnUnit::bytes).caret, 2);
    EXPECT_EQ(shownLine("ab", 99, ColumnUnit::bytes).caret, 2);
    EXPECT_EQ(shownLine("", 1, ColumnUnit::bytes).caret, 0);
}

TEST(ExcerptLine, UnknownColumn_NoCaret)
{
    EXPECT_EQ(shownLine("ab", 0, ColumnUnit::bytes).caret, -1);
}

} // namespace dioptre::test
