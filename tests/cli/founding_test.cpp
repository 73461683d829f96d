// The scene that is written into a shader looks like the same scene in a file.
#include "support/compare.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace dioptre;

namespace
{

using FoundingShader = test::InAFolder;

// glsl/scenes/founding.frag at 2 s, when its moon is at +z.
constexpr const char* sameScene = R"(
[camera]
eye = [0, 2, 6]
target = [0, 0.8, 0]
fov_y_deg = 40
[sky]
gradient = [[0.5, 0.45, 0.4], [0.75, 0.8, 0.9], [0.15, 0.3, 0.65]]
[trace]
budget = 8
[[light]]
kind = "ambient"
ambient = [0.15, 0.18, 0.24]
[[light]]
kind = "directional"
direction = [-0.5, -1, -0.4]
diffuse = [1, 0.95, 0.85]
[material.ball]
mirror = 0.9
mirror_colour = [1.0, 0.97777777777, 0.88888888888]
[material.moon]
colour = [0.8, 0.25, 0.1]
[material.floor]
pattern = "checker"
colours = [[0.75, 0.72, 0.65], [0.12, 0.16, 0.25]]
size = 0.8
[[sphere]]
centre = [0, 1, 0]
radius = 1
material = "ball"
[[sphere]]
centre = [0, 0.45, 1.9]
radius = 0.45
material = "moon"
[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
)";

} // namespace

TEST_F(FoundingShader, LooksLikeTheSameSceneInAFile)
{
    std::ofstream(folder / "same.toml") << sameScene;
    const auto outcome = here("dioptre render founding --size 160x90 --time 2 && "
                              "dioptre render same.toml --size 160x90 --spp 4");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto shader = test::decoded(readPicture(folder / "founding.png"));
    const auto file = test::decoded(readPicture(folder / "same.png"));
    // Both round to 8 bits, each in its own way; a sample may fall on the other side of a field's edge.
    const auto difference = test::compareEncoded(shader, file, 1.5);
    EXPECT_LE(difference.over, difference.pixels / 200) << test::saveForTheEye("founding", shader, file);
}
