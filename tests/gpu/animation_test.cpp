// The animated scenes of the gallery away from 0 s: one picture at each time by every way to draw it, and
// another at another time.
#include "support/compare.h"
#include "support/rendering.h"

#include "base/file.h"

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

std::vector<std::filesystem::path> animatedScenes()
{
    auto scenes = galleryScenes();
    std::erase_if(scenes,
                  [](const auto& scene) { return readFile(scene).find("[[animate]]") == std::string::npos; });
    return scenes;
}

Request requestAt(double time_s, const std::string& form)
{
    return {160, 90, 1, {"trace.form=" + form}, "auto", time_s};
}

// The bounds of agreement_test.cpp, for the same reasons.
void expectAlike(const Picture& a, const Picture& b, const std::string& what)
{
    const auto difference = compare(a, b, 0.01);
    EXPECT_LT(difference.rmse, 0.002) << saveForTheEye(what, a, b);
    EXPECT_LT(difference.over, difference.pixels / 200) << what;
}

class AnimatedGallery : public testing::TestWithParam<std::filesystem::path>
{
};

INSTANTIATE_TEST_SUITE_P(Scenes, AnimatedGallery, testing::ValuesIn(animatedScenes()),
                         [](const auto& info) { return info.param.stem().string(); });

} // namespace

TEST_P(AnimatedGallery, AtAnyTime_FormsAndPrecisionsAgree)
{
    const auto name = GetParam().stem().string();
    for (const double time_s : {1.7, 6.4}) {
        const auto literal = test::renderScene(GetParam(), requestAt(time_s, "literal"));
        const auto loop = test::renderScene(GetParam(), requestAt(time_s, "loop"));
        expectAlike(literal.picture, loop.picture, "animated-form-" + name);
        expectAlike(literal.picture, renderDouble(GetParam(), requestAt(time_s, "literal")),
                    "animated-double-" + name);
        EXPECT_EQ(literal.counts.nonfinite, 0U);
    }
}

TEST_P(AnimatedGallery, AtAnotherTime_ThePictureIsAnother)
{
    const auto still = [&](double time_s) {
        return test::renderScene(GetParam(), requestAt(time_s, "literal")).picture;
    };
    EXPECT_GT(compare(still(0.0), still(2.0), 0.01).rmse, 0.02);
}
