#include "gl/program.h"

#include <gtest/gtest.h>

namespace dioptre
{

// For the messages of failed tests.
static bool operator==(const LogMessage& a, const LogMessage& b)
{
    return a.line == b.line && a.column == b.column && a.text == b.text && a.collapsed == b.collapsed;
}

static void PrintTo(const LogMessage& message, std::ostream* out)
{
    *out << message.line << ':' << message.column << (message.collapsed ? " ~ " : " | ") << message.text;
}

namespace
{

using Messages = std::vector<LogMessage>;

// Mesa 22.3.6, llvmpipe: source:line(column), the column that of the preprocessed line but for the
// preprocessor's own messages.
TEST(Log, Mesa_LineIsTheSecondNumberAndTheColumnFollows)
{
    EXPECT_EQ(parseLog("0:12(11): error: `foo' undeclared\n"
                       "0:9(1): warning: `x' used uninitialized\n"
                       "0:120(34): preprocessor error: Undefined macro A: in expression\n"),
              (Messages{{12, 11, "error: `foo' undeclared", true},
                        {9, 1, "warning: `x' used uninitialized", true},
                        {120, 34, "preprocessor error: Undefined macro A: in expression"}}));
}

// NVIDIA 470 and later: source(line), with a terminating NUL that the driver counts.
TEST(Log, Nvidia_LineIsInTheBrackets)
{
    EXPECT_EQ(parseLog(std::string("0(12) : error C1503: undefined variable \"foo\"\n"
                                   "0(3) : warning C7022: unrecognized profile specifier \"a\"\n\0",
                                   105)),
              (Messages{{12, 0, "error C1503: undefined variable \"foo\""},
                        {3, 0, "warning C7022: unrecognized profile specifier \"a\""}}));
}

TEST(Log, Nvidia_HeadingOfALinkLog_IsKeptWithoutALine)
{
    EXPECT_EQ(parseLog("Fragment info\n-------------\n0(7) : error C5051: array\n"),
              (Messages{{0, 0, "Fragment info"}, {0, 0, "-------------"}, {7, 0, "error C5051: array"}}));
}

// ANGLE, Intel on Windows and macOS; AMD adds "error(#143)".
TEST(Log, AmdIntelAngle_SeverityStandsFirst)
{
    EXPECT_EQ(parseLog("ERROR: 0:12: 'foo' : undeclared identifier\r\n"
                       "WARNING: 0:4: 'x' : unused\r\n"
                       "ERROR: 0:5: error(#143) Undeclared identifier: bar\r\n"),
              (Messages{{12, 0, "error: 'foo' : undeclared identifier"},
                        {4, 0, "warning: 'x' : unused"},
                        {5, 0, "error: error(#143) Undeclared identifier: bar"}}));
}

TEST(Log, ColumnInBracketsBehindTheSeverity_IsRead)
{
    EXPECT_EQ(parseLog("ERROR: 0:12(5): 'foo' : undeclared\nWARNING: 0:4(17): 'x' : unused\n"),
              (Messages{{12, 5, "error: 'foo' : undeclared"}, {4, 17, "warning: 'x' : unused"}}));
}

// glslangValidator 12 on standard input.
TEST(Log, Glslang_CountOfErrors_IsKeptWithoutALine)
{
    EXPECT_EQ(parseLog("ERROR: 0:2: '' :  syntax error, unexpected IDENTIFIER\n"
                       "ERROR: 1 compilation errors.  No code generated.\n\n\n"),
              (Messages{{2, 0, "error: '' :  syntax error, unexpected IDENTIFIER"},
                        {0, 0, "ERROR: 1 compilation errors.  No code generated."}}));
}

TEST(Log, NumbersInsideAMessage_AreNotItsPlace)
{
    EXPECT_EQ(parseLog("error: vec3(1): 0:12: too few"), (Messages{{0, 0, "error: vec3(1): 0:12: too few"}}));
    EXPECT_EQ(parseLog("99999999999:99999999999(1): error: x"),
              (Messages{{0, 0, "99999999999:99999999999(1): error: x"}}));
}

TEST(Log, Empty_HasNoMessages)
{
    EXPECT_TRUE(parseLog("").empty());
    EXPECT_TRUE(parseLog("\n \n").empty());
}

TEST(Log, LongMessage_IsReadWhole)
{
    const std::string text = "error: " + std::string(1000000, 'x');
    EXPECT_EQ(parseLog("0:5(1): " + text).at(0).text.size(), text.size());
}

} // namespace
} // namespace dioptre
