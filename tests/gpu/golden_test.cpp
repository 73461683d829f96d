// Small pictures of the gallery as they were when somebody looked at them: they catch what changes without
// being meant to. tests/golden/update makes them anew; look at them before they are committed.
#include "support/compare.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class Golden : public testing::TestWithParam<std::tuple<std::filesystem::path, std::string>>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(
    Gallery, Golden, testing::Combine(testing::ValuesIn(galleryScenes()), testing::Values("egl", "osmesa")),
    [](const auto& info) { return std::get<0>(info.param).stem().string() + "_" + std::get<1>(info.param); });

TEST_P(Golden, Picture_IsTheOneThatWasLookedAt)
{
    const auto& [scene, backend] = GetParam();
    const auto file =
        std::filesystem::path(DIOPTRE_SOURCE_DIR) / "tests" / "golden" / (scene.stem().string() + ".png");
    const auto expected = decoded(readPicture(file));
    // Pictures that a machine may have or not have are replaced by our own.
    const Request request{expected.width, expected.height, 4, ownPictures(scene), backend};
    const auto actual = test::renderScene(scene, request).picture;
    // CPUs differ in approximate reciprocals, which moves edges: 3/255 on all but one pixel in two hundred.
    const auto difference = compareEncoded(actual, expected, 3.0);
    EXPECT_LE(difference.over, difference.pixels / 200)
        << saveForTheEye("golden-" + scene.stem().string() + "-" + backend, actual, expected);
}
