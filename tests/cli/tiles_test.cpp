// Parts of a picture by --tile, put together: to the very file that one machine draws, or a reason why not.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace dioptre;

namespace
{

// A floor, a mirror, a light and a sky: little to compile, and no two rows alike.
constexpr const char* ballToml = R"([camera]
eye = [0, 1, 5]
[sky]
gradient = [[0.3, 0.2, 0.2], [0.8, 0.8, 0.7], [0.2, 0.3, 2.6]]
[material.m]
colour = [0.7, 0.3, 0.2]
mirror = 0.4
[[light]]
kind = "point"
position = [2, 4, 3]
diffuse = [0.8, 0.8, 0.8]
[[sphere]]
name = "ball"
centre = [0, 1, 0]
radius = 1
material = "m"
[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "m"
)";

// A channel, a place in the picture, and a derivative, whose groups of pixels no tile may cut.
constexpr const char* channelFrag = R"(void mainImage(out vec4 o, in vec2 p)
{
    vec2 uv = p / iResolution.xy;
    vec4 texel = texture(iChannel0, 3.0 * uv);
    o = vec4(texel.r, uv.y + 0.1 * texel.g, abs(dFdy(sin(p.y * p.x))), 1.0);
}
)";

class Tiles : public test::InAFolder
{
protected:
    Tiles()
    {
        std::ofstream(folder / "ball.toml") << ballToml;
        std::ofstream(folder / "channel.frag") << channelFrag;
    }

    void drawTiles(const std::string& what, const std::string& kind, int tiles) const
    {
        for (int tile = 1; tile <= tiles; ++tile) {
            const std::string part = std::to_string(tile);
            const auto outcome = here("dioptre render " + what + " --tile " + part + "/" +
                                      std::to_string(tiles) + " -o " + part + kind);
            ASSERT_EQ(outcome.code, 0) << what << "\n" << outcome.error;
        }
    }

    // Joined in an order that is not theirs.
    void joinTiles(const std::string& kind, int tiles) const
    {
        std::string parts;
        for (int tile = 1; tile <= tiles; ++tile)
            parts = " " + std::to_string(tile) + kind + parts;
        const auto outcome = here("dioptre join" + parts + " -o joined" + kind);
        ASSERT_EQ(outcome.code, 0) << outcome.error;
    }

    void expectTilesToMakeTheFile(const std::string& what, const std::string& kind,
                                  const std::vector<int>& numbers) const
    {
        const auto outcome = here("dioptre render " + what + " -o whole" + kind);
        ASSERT_EQ(outcome.code, 0) << outcome.error;
        for (const int tiles : numbers) {
            drawTiles(what, kind, tiles);
            joinTiles(kind, tiles);
            EXPECT_TRUE(readFile(folder / ("joined" + kind)) == readFile(folder / ("whole" + kind)))
                << what << " by " << tiles << " tiles";
        }
    }

    std::string refusalOf(const std::string& command, int code) const
    {
        const auto outcome = here(command);
        EXPECT_EQ(outcome.code, code) << command << "\n" << outcome.error;
        EXPECT_EQ(outcome.out, "") << command;
        return outcome.error;
    }

    bool isThere(const std::string& name) const
    {
        return std::filesystem::exists(folder / name);
    }
};

// 150 rows are two groups of 64 and one of 22, which is the topmost.
const std::string oddSize = " --size 83x150 ";
constexpr int mostOfOdd = 3;

} // namespace

TEST_F(Tiles, OfAScene_MakeTheFileOfOneMachine_InEveryKindOfFile)
{
    const std::string ball = "ball.toml --spp 4" + oddSize;
    expectTilesToMakeTheFile(ball, ".png", {1, 2, mostOfOdd});
    expectTilesToMakeTheFile(ball + "--depth 16 --exposure 1 --curve filmic", ".png", {mostOfOdd});
    expectTilesToMakeTheFile(ball, ".hdr", {mostOfOdd});
    expectTilesToMakeTheFile(ball, ".exr", {2});
    expectTilesToMakeTheFile(ball + "--half", ".exr", {mostOfOdd});
    expectTilesToMakeTheFile(ball + "--layers depth,normal,object", ".exr", {mostOfOdd});
}

TEST_F(Tiles, OfAPlainShader_MakeTheFileOfOneMachine)
{
    ASSERT_EQ(here("dioptre render ball.toml --spp 1 --size 31x17 -o channel.png").code, 0);
    expectTilesToMakeTheFile("channel.frag --channel0 channel.png" + oddSize, ".png", {1, 2, mostOfOdd});
    expectTilesToMakeTheFile("channel.frag --channel0 channel.png" + oddSize, ".exr", {mostOfOdd});
}

// The parts of a picture that have programs of their own are another thing: those cut across these.
TEST_F(Tiles, OfAPictureByPrograms_MakeTheFileOfOneMachine)
{
    expectTilesToMakeTheFile("still_life --spp 1 --set plan.tiles=on --size 150x131", ".png", {mostOfOdd});
}

TEST_F(Tiles, OfTheReference_MakeTheFileOfOneMachine)
{
    expectTilesToMakeTheFile("ball.toml --reference --spp 2" + oddSize, ".exr", {2, mostOfOdd});
}

TEST_F(Tiles, OfAView_MakeTheExrOfOneMachine)
{
    for (const std::string view : {"depth", "rays", "object"})
        expectTilesToMakeTheFile("ball.toml --spp 1 --view " + view + oddSize, ".exr", {mostOfOdd});
}

TEST_F(Tiles, OfAViewForTheEye_AreRefused)
{
    const auto error = refusalOf("dioptre render ball.toml --view depth --tile 1/2 -o a.png" + oddSize, 2);
    EXPECT_NE(error.find("--view depth takes its colours from the whole picture"), std::string::npos)
        << error;
    EXPECT_NE(error.find(".exr"), std::string::npos) << error;
    EXPECT_FALSE(isThere("a.png"));
}

TEST_F(Tiles, WithoutOutput_AreNamedAfterTheSceneAndTheTile)
{
    const auto outcome = here("dioptre render ball.toml --tile 2/3 --spp 1" + oddSize);
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_TRUE(isThere("ball-2-of-3.png"));
    EXPECT_NE(outcome.error.find("ball-2-of-3.png: tile 2/3 of 83x150"), std::string::npos) << outcome.error;
    const auto settings = readSettings(folder / "ball-2-of-3.png");
    EXPECT_EQ(settings.at("dioptre.tile"), "2/3");
    EXPECT_EQ(settings.at("dioptre.size"), "83x150");
}

TEST_F(Tiles, OfDifferentSettings_AreRefusedWithBothValues)
{
    struct {
        std::string first, second, key, mine, other;
    } const cases[] = {
        {"--spp 1", "--spp 2", "dioptre.spp", "'2'", "'1'"},
        {"--spp 1 --set ball.radius=0.5", "--spp 1 --set ball.radius=0.75", "dioptre.set",
         "'ball.radius=0.75'", "'ball.radius=0.5'"},
        {"--spp 1 --exposure 1", "--spp 1 --exposure 2", "dioptre.exposure", "'2'", "'1'"},
        {"--spp 1", "--spp 1 --time 2", "dioptre.time", "'2'", "'0'"},
        {"--spp 1", "--spp 1 --budget 3", "dioptre.set", "'trace.budget=3'", "nothing"},
    };
    for (const auto& row : cases) {
        const std::string command = "dioptre render ball.toml" + oddSize;
        ASSERT_EQ(here(command + row.first + " --tile 1/2 -o 1.png && " + command + row.second +
                       " --tile 2/2 -o 2.png")
                      .code,
                  0);
        const auto error = refusalOf("dioptre join 1.png 2.png -o joined.png", 65);
        const std::string says =
            "2.png: its " + row.key + " is " + row.mine + ", and " + row.other + " of 1.png";
        EXPECT_NE(error.find(says), std::string::npos) << says << " is not in\n" << error;
        EXPECT_FALSE(isThere("joined.png"));
    }
}

TEST_F(Tiles, OfAnotherText_PictureOrChannel_AreRefused)
{
    const std::string one = " --spp 1" + oddSize + "--tile 1/2 -o 1.png",
                      two = " --spp 1" + oddSize + "--tile 2/2 -o 2.png";
    ASSERT_EQ(here("dioptre render ball.toml" + one +
                   " && sed -i 's/radius = 1/radius = 2/' ball.toml && "
                   "dioptre render ball.toml" +
                   two)
                  .code,
              0);
    const std::string says =
        "2.png: was drawn from another scene, other shaders or pictures, or with other options than 1.png";
    auto error = refusalOf("dioptre join 1.png 2.png -o joined.png", 65);
    EXPECT_NE(error.find(says), std::string::npos) << error;
    const std::string paint = "dioptre render ball.toml --size 8x8 -o channel.png --spp ";
    const std::string shader = "dioptre render channel.frag --channel0 channel.png";
    ASSERT_EQ(here(paint + "1 && " + shader + one + " && " + paint + "4 && " + shader + two).code, 0);
    error = refusalOf("dioptre join 1.png 2.png -o joined.png", 65);
    EXPECT_NE(error.find(says), std::string::npos) << error;
    EXPECT_FALSE(isThere("joined.png"));
}

// The light's shader is the same: only that of the layer differs.
TEST_F(Tiles, OfAnotherLayersShader_AreRefused)
{
    const std::string copy = "cp -r '" DIOPTRE_SOURCE_DIR
                             "/glsl' edited && sed -i 's/vec3(hit.t, 1.0, 0.0)/vec3(2.0 * hit.t, 1.0, 0.0)/' "
                             "edited/trace/first_hit.glsl";
    const std::string half = " --spp 1 --layers depth" + oddSize;
    ASSERT_EQ(here(copy + " && dioptre render ball.toml --tile 1/2 -o 1.exr" + half +
                   " && DIOPTRE_GLSL=edited dioptre render ball.toml --tile 2/2 -o 2.exr" + half)
                  .code,
              0);
    const auto error = refusalOf("dioptre join 1.exr 2.exr -o joined.exr", 65);
    EXPECT_NE(error.find("other shaders"), std::string::npos) << error;
}

TEST_F(Tiles, ThatAreNone_AreRefusedBeforeAnythingIsDrawn)
{
    for (const std::string tile : {"0/3", "4/3", "1/0", "0/0", "-1/3", "1/-3", "a/b", "1", "1/", "/3", "1/3x",
                                   "1/3/3", "1.5/3", "99999999999/3", "1/99999999999"}) {
        const auto error = refusalOf("dioptre render ball.toml --tile=" + tile + " -o a.png" + oddSize, 2);
        EXPECT_NE(error.find("--tile " + tile + " is no tile"), std::string::npos) << tile << "\n" << error;
        EXPECT_NE(error.find("I/N"), std::string::npos) << error;
        EXPECT_FALSE(isThere("a.png"));
    }
    const auto error = refusalOf("dioptre render ball.toml --tile 1/4 -o a.png" + oddSize, 2);
    EXPECT_NE(error.find("--tile 1/4: a picture of 150 rows has no more than 3 tiles"), std::string::npos)
        << error;
}

TEST_F(Tiles, OfFrames_AreRefused)
{
    const auto error = refusalOf("dioptre render ball.toml --tile 1/2 --frames 0:1 -o a.png" + oddSize, 2);
    EXPECT_NE(error.find("--tile"), std::string::npos) << error;
    EXPECT_NE(error.find("--frames"), std::string::npos) << error;
    EXPECT_TRUE(!isThere("a.png") && !isThere("a.0000.png"));
}
