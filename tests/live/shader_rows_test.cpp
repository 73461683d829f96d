// A plain shader's sliders.
#include "live/panel_shader_rows.h"

#include <gtest/gtest.h>

namespace dioptre::test
{
namespace
{

std::vector<Annotation> annotated()
{
    return annotationsOf(linesOf("uniform float u_time;\n"
                                 "uniform float u_left; // 0.25 [0, 2] what the left side is\n"
                                 "uniform vec3 u_tint; // #ff8800 of the right side\n"
                                 "uniform vec3 u_axis; // [0, 1, 0] [-1, 1] up\n"
                                 "uniform int u_side; // 4 [1, 8] pixels\n"
                                 "uniform bool u_both; // true\n",
                                 "a.frag"));
}

const std::vector<std::string> all{"u_time", "u_left", "u_tint", "u_axis", "u_side", "u_both"};

} // namespace

TEST(ShaderRows, EachType_HasItsWidget)
{
    const auto rows = shaderRows(annotated(), all, {}, {});
    ASSERT_EQ(rows.size(), 5U); // time is the host's
    const std::vector<RowKind> kinds{RowKind::number, RowKind::colour, RowKind::vector, RowKind::integer,
                                     RowKind::toggle};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        EXPECT_EQ(rows[i].kind, kinds[i]) << rows[i].path;
    EXPECT_EQ(rows[0].numbers, std::vector<double>{0.25});
    EXPECT_EQ(rows[0].high, 2.0);
    EXPECT_EQ(rows[2].low, -1.0);
}

TEST(ShaderRows, UniformsThatTheProgramDoesNotRead_AreLeftOut)
{
    const auto rows = shaderRows(annotated(), {"u_side"}, {}, {});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows.front().path, "u_side");
}

TEST(ShaderRows, UniformsOfTheAssembler_AreLeftOut)
{
    const auto own = annotationsOf(linesOf("uniform int dioptre_two; // 2\n", "generated"));
    EXPECT_EQ(own.size(), 1U);
    EXPECT_TRUE(shaderRows(own, {"dioptre_two"}, {}, {}).empty());
}

TEST(ShaderRows, MovedSlider_ShowsWhereItStands)
{
    const auto rows = shaderRows(annotated(), all, {}, {{"u_left", {1.5}}});
    EXPECT_EQ(rows.front().numbers, std::vector<double>{1.5});
}

TEST(ShaderRows, ValueOfTheCommandLine_IsFixed)
{
    const auto rows = shaderRows(annotated(), all, {{"u_left", "0.5"}}, {});
    EXPECT_EQ(rows[0].fixedBy, "--set 0.5");
    EXPECT_EQ(rows[1].fixedBy, "");
}

} // namespace dioptre::test
