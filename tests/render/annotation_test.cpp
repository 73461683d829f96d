// What authors say of uniforms in comments.
#include "render/annotation.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

using Values = std::vector<double>;

std::vector<Annotation> in(const std::string& text)
{
    return annotationsOf(linesOf(text, "a.frag"));
}

Annotation one(const std::string& line)
{
    const auto found = in(line);
    EXPECT_EQ(found.size(), 1U) << line;
    return found.empty() ? Annotation{} : found.front();
}

void expectColumns(const std::optional<ValueColumns>& columns, const std::string& line,
                   const std::string& text)
{
    ASSERT_TRUE(columns.has_value()) << line;
    EXPECT_EQ(
        line.substr(static_cast<std::size_t>(columns->first) - 1, static_cast<std::size_t>(columns->count)),
        text);
}

std::string faultOf(const std::string& text)
{
    try {
        in(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        return error.what();
    }
    return "";
}

} // namespace

TEST(Annotation, ValueRangeAndLabel_AreRead)
{
    const std::string line = "uniform float u_roughness; // 0.3 [0.02, 1.0] microfacet roughness";
    const auto found = one(line);
    EXPECT_EQ(found.name, "u_roughness");
    EXPECT_EQ(found.type, "float");
    EXPECT_EQ(found.defaults, Values{0.3});
    EXPECT_EQ(found.low, 0.02);
    EXPECT_EQ(found.high, 1.0);
    EXPECT_EQ(found.label, "microfacet roughness");
    EXPECT_EQ(describe(found.where), "a.frag:1:15");
    expectColumns(found.inComment, line, "0.3");
    EXPECT_FALSE(found.inDeclaration);
}

TEST(Annotation, ColoursAndVectors_AreRead)
{
    const auto tint = one("uniform vec3 u_tint; // #ff8800 colour");
    EXPECT_EQ(tint.defaults, (Values{1.0, 136 / 255.0, 0.0}));
    EXPECT_EQ(tint.high, 1.0);
    EXPECT_EQ(tint.label, "colour");
    const auto given = one("uniform vec3 u_tint; //[1, 0.5, 0.2]  [0, 1]  of the ball ");
    EXPECT_EQ(given.defaults, (Values{1.0, 0.5, 0.2}));
    EXPECT_EQ(given.label, "of the ball");
    EXPECT_EQ(one("uniform vec4 v; // [1,2,3,4]").defaults, (Values{1, 2, 3, 4}));
    EXPECT_EQ(one("uniform highp vec2 v; // [-1, 2]").low, -4.0);
}

TEST(Annotation, WholeNumbersAndFlags_AreRead)
{
    const auto count = one("uniform int u_n; // 3 [1, 9]");
    EXPECT_EQ(count.defaults, Values{3});
    EXPECT_EQ(count.high, 9.0);
    EXPECT_EQ(one("uniform bool u_on; // true").defaults, Values{1});
    EXPECT_EQ(one("uniform bool u_on; // false quietly").label, "quietly");
    EXPECT_EQ(one("uniform uint u_n = 3u;").defaults, Values{3});
}

TEST(Annotation, RangeThatIsNotGiven_ReachesAboutTheValue)
{
    EXPECT_EQ(one("uniform float a = 2.0;").high, 4.0);
    EXPECT_EQ(one("uniform float a = 2.0;").low, 0.0);
    EXPECT_EQ(one("uniform float a = -2.0;").low, -4.0);
    EXPECT_EQ(one("uniform float a = -2.0;").high, 4.0);
    EXPECT_EQ(one("uniform float a;").high, 1.0);
    EXPECT_EQ(one("uniform float a; // 5").high, 10.0);
    EXPECT_EQ(one("uniform bool a; // true").high, 1.0);
}

TEST(Annotation, ValueOfTheDeclaration_GoesBeforeTheComments)
{
    const std::string line = "uniform vec3 a = vec3(0.5, 1.0, 2.0); // [1, 1, 1] [0, 3] label";
    const auto found = one(line);
    EXPECT_EQ(found.defaults, (Values{0.5, 1.0, 2.0}));
    expectColumns(found.inDeclaration, line, "vec3(0.5, 1.0, 2.0)");
    expectColumns(found.inComment, line, "[1, 1, 1]");
    EXPECT_EQ(one("uniform vec2 a = vec2(0.5);").defaults, (Values{0.5, 0.5}));
    EXPECT_FALSE(one("uniform float a = 1.0 / 3.0; // 0.3").inDeclaration);
    EXPECT_EQ(one("uniform float a = 1.0 / 3.0; // 0.3").defaults, Values{0.3});
}

TEST(Annotation, FreeText_IsNone)
{
    for (const char* comment : {"speed", "3d noise", "1.0, or less", "[m/s]", "[0,1) of it", "#1 of all",
                                "nan", "true north", "", "-"}) {
        const auto found = one("uniform float a; // " + std::string(comment));
        EXPECT_FALSE(found.inComment) << comment;
        EXPECT_EQ(found.label, "") << comment;
    }
    EXPECT_FALSE(one("uniform vec3 a; // 3 components").inComment);
    EXPECT_FALSE(one("uniform bool a; // 2 ways").inComment);
}

TEST(Annotation, OtherUniforms_HaveNone)
{
    EXPECT_TRUE(
        in("uniform sampler2D iChannel0; // 1\nuniform mat3 m; // 1\nuniform float a[3]; // 1\n"
           "uniform float a, b; // 1\nuniform Block { float c; }; // 1\n// uniform float d; // 1\n"
           "/* uniform float e; // 1\n*/\n#define F uniform float f; // 1\nfloat g; // 1\nuniform float h")
            .empty());
}

TEST(Annotation, Faults_NameThePlaceAndTheMend)
{
    const std::pair<const char*, const char*> faults[] = {
        {"\nuniform float a; // 0.5 [1, 0]", "a.frag:2:25: [1, 0] is a range whose lower end is not below "
                                             "its upper one: write the lower first: [0, 1]"},
        {"uniform float a; // 2 [0, 1]",
         "a.frag:1:21: 2 is outside the range [0, 1]: widen the range, or start within it"},
        {"uniform float a = 2.0; // 1 [0, 1]", "a.frag:1:19: 2.0 is outside the range [0, 1]"},
        {"uniform float a; // 0.5 [0, 1, 2]", "a.frag:1:25: [0, 1, 2] is no range for type float"},
        {"uniform bool a; // true [0, 1]", "a.frag:1:25: [0, 1] is no range for type bool: leave it out"},
        {"uniform vec3 a; // [1, 2]",
         "a.frag:1:20: [1, 2] is no value of type vec3: give 3 numbers in brackets"},
        {"uniform vec3 a; // 0.5 [0, 1]", "a.frag:1:20: 0.5 is no value of type vec3"},
        {"uniform float a; // [0, 1] size", "a.frag:1:21: [0, 1] is no value of type float: give one number"},
        {"uniform int a; // 0.5 [0, 1]", "a.frag:1:19: 0.5 is no value of type int: give one whole number"},
        {"uniform float a; // #ff0000", "a.frag:1:21: #ff0000 is no value of type float"}};
    for (const auto& [text, says] : faults)
        EXPECT_EQ(faultOf(text).find(says), 0U) << text << "\n" << faultOf(text);
}

TEST(WithDefaults, NewValues_StandInTheirPlaces_AndNothingElseChanges)
{
    const std::string before = "\xEF\xBB\xBF// 1\r\nuniform float a;\t// 0.3 [0, 9] label 0.3\r\n"
                               "uniform vec3 b = vec3( 1.0 );//#ff8800  tint\n\nuniform int c; // 3\r"
                               "uniform bool d; // true\nuniform float e = 2.0; // free\nuniform uint f = "
                               "3u;\nuniform vec2 g; // [1, 2]";
    const std::string after = "\xEF\xBB\xBF// 1\r\nuniform float a;\t// 1.25 [0, 9] label 0.3\r\n"
                              "uniform vec3 b = vec3(0.0, 1.0, 0.2);//#00ff33  tint\n\nuniform int c; // 7\r"
                              "uniform bool d; // false\nuniform float e = 3.0; // free\nuniform uint f = "
                              "4u;\nuniform vec2 g; // [0.1, 2]";
    const std::map<std::string, Values> values = {
        {"a", {1.25}}, {"b", {0.0, 1.0, 0.2}}, {"c", {7}},      {"d", {0}}, {"e", {3}},
        {"f", {4}},    {"g", {0.1, 2}},        {"nothing", {1}}};
    EXPECT_EQ(withDefaults(before, values), after);
    EXPECT_EQ(withDefaults(after, values), after);
    EXPECT_EQ(withDefaults(before, {}), before);
}

TEST(WithDefaults, ColourThatNoBytesSay_IsWrittenAsNumbers)
{
    EXPECT_EQ(withDefaults("uniform vec3 b; // #ff8800 tint", {{"b", {0.5, 0.25, 1.0}}}),
              "uniform vec3 b; // [0.5, 0.25, 1] tint");
}

TEST(WithDefaults, WhatItWrites_IsReadBack)
{
    const auto text = withDefaults("uniform vec2 a = vec2(1.0); // [1, 1] [-9, 9]", {{"a", {-0.1, 1e-7}}});
    const auto found = one(text);
    EXPECT_NEAR(found.defaults[0], -0.1, 1e-8);
    EXPECT_NEAR(found.defaults[1], 1e-7, 1e-14);
}
