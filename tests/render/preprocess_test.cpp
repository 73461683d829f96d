#include "render/preprocess.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

PreprocessInput inputWith(std::map<std::string, std::string> files, std::set<std::string> features = {})
{
    PreprocessInput input;
    input.search.folders = {"/nowhere"};
    for (const auto& [name, text] : files)
        input.generated[name] = linesOf(text, name);
    input.features = std::move(features);
    return input;
}

std::string preprocessed(const std::string& text, const PreprocessInput& input)
{
    return flatten(preprocess(linesOf(text, "main"), input));
}

} // namespace

TEST(Preprocess, WhatAFeatureGuards_IsInTheTextOnlyWithIt)
{
    const std::string text =
        "#ifdef HAS_A\na\n#ifdef HAS_B\nab\n#else\na_alone\n#endif\n#else\nno_a\n#endif\nend\n";
    EXPECT_EQ(preprocessed(text, inputWith({})), "no_a\nend\n");
    EXPECT_EQ(preprocessed(text, inputWith({}, {"HAS_A"})), "a\na_alone\nend\n");
    EXPECT_EQ(preprocessed(text, inputWith({}, {"HAS_A", "HAS_B"})), "a\nab\nend\n");
}

TEST(Preprocess, ConditionalsOfTheAuthor_AreLeftToTheDriver)
{
    const std::string text = "#ifdef GL_ES\nprecision highp float;\n#else\nx\n#endif\n#if 1\ny\n#endif\n";
    EXPECT_EQ(preprocessed(text, inputWith({})), text);
}

TEST(Preprocess, NestedIncludes_KeepFileAndLine)
{
    const auto input = inputWith({{"a", "a1\n#include \"b\"\na3\n"}, {"b", "b1\nb2\n"}});
    const auto result = preprocess(linesOf("m1\n#include \"a\"\nm3\n", "main"), input);
    ASSERT_EQ(result.size(), 6U);
    EXPECT_EQ(result[2].file + ":" + std::to_string(result[2].line), "b:1");
    EXPECT_EQ(result[4].file + ":" + std::to_string(result[4].line), "a:3");
    EXPECT_EQ(result[5].file + ":" + std::to_string(result[5].line), "main:3");
}

TEST(Preprocess, AFileIncludedTwice_IsTakenOnce)
{
    EXPECT_EQ(preprocessed("#include \"a\"\n#include \"a\"\n", inputWith({{"a", "once\n"}})), "once\n");
}

TEST(Preprocess, ACircleOfIncludes_IsNamed)
{
    try {
        preprocessed("#include \"a\"\n", inputWith({{"a", "\n#include \"b\"\n"}, {"b", "#include \"a\"\n"}}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        EXPECT_NE(std::string(error.what()).find("b:1"), std::string::npos) << error.what();
    }
}

TEST(Preprocess, AMissingEndif_IsNamedWhereItsIfStands)
{
    try {
        preprocessed("x\n#ifdef HAS_A\n", inputWith({}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("main:2"), std::string::npos) << error.what();
    }
}

TEST(Preprocess, ConditionalsWithinOnesThatAreOut_StayOutOnBothSides)
{
    EXPECT_EQ(
        preprocessed(
            "#ifdef HAS_A\n#ifndef HAS_B\nx\n#else\ny\n#endif\n#if 1\nz\n#else\nw\n#endif\n#endif\nend\n",
            inputWith({})),
        "end\n");
}

TEST(SourceText, EveryEndOfLineAndAByteOrderMark_AreRead)
{
    const auto lines = linesOf("\xEF\xBB\xBF"
                               "a\r\nb\rc\n\nd",
                               "f");
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0].text, "a");
    EXPECT_EQ(lines[2].text, "c");
    EXPECT_EQ(lines[4].text, "d");
    EXPECT_EQ(lines[4].line, 5);
}
