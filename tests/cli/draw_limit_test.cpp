// --draw-limit: a shader that does not come to an end is an error, in place of a wait for ever.
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace dioptre;

namespace
{

// About as many iterations as a software driver lets run: seconds for 16x16 pixels, the smallest draw.
constexpr const char* heavyFrag = R"(
#define STIR v = sin(v.yzwx + cos(v.zwxy * 1.7)) - log(abs(v.wxyz) + 0.5);
void mainImage(out vec4 o, in vec2 p)
{
    vec4 v = vec4(p, 1.0, 2.0);
    for (int i = 0; i < 60000; ++i) {
        STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR STIR
    }
    o = v;
}
)";

class DrawLimit : public test::InAFolder
{
protected:
    DrawLimit()
    {
        std::ofstream(folder / "heavy.frag") << heavyFrag;
    }

    std::size_t files() const
    {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
    }
};

} // namespace

TEST_F(DrawLimit, ADrawThatTakesLonger_IsAnErrorWithItsMend)
{
    const auto outcome = here("dioptre render heavy.frag --size 64x64 --draw-limit 0.2 -o a.png");
    EXPECT_EQ(outcome.code, 65) << outcome.error;
    EXPECT_NE(outcome.error.find("not done after 0.2 s"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("loop that does not end"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("--draw-limit"), std::string::npos) << outcome.error;
    EXPECT_EQ(files(), 1U) << "the shader alone";
}

TEST_F(DrawLimit, ThatIsNoTime_IsRefused)
{
    for (const std::string limit : {"0", "-1", "nan", "inf", "-inf"}) {
        const auto outcome = here("dioptre render heavy.frag --draw-limit=" + limit + " -o a.png");
        EXPECT_EQ(outcome.code, 2) << limit;
        EXPECT_NE(outcome.error.find("--draw-limit " + limit + " is no time"), std::string::npos)
            << outcome.error;
    }
    EXPECT_EQ(here("dioptre render heavy.frag --draw-limit soon -o a.png").code, 2);
    EXPECT_EQ(files(), 1U);
}
