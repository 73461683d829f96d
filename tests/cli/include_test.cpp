// --include: folders that scenes and shaders may take files from.
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace dioptre;

namespace
{

class Include : public test::InAFolder
{
protected:
    Include()
    {
        std::filesystem::create_directories(folder / "own");
        std::filesystem::create_directories(folder / "shared");
        std::ofstream(folder / "own/p.frag")
            << "#include \"colour.glsl\"\nvoid mainImage(out vec4 o, in vec2 p)\n"
               "{\n    o = vec4(colour, 1.0);\n}\n";
        std::ofstream(folder / "shared/colour.glsl") << "const vec3 colour = vec3(1.0, 0.0, 0.0);\n";
        std::ofstream(folder / "own/s.toml") << "[sky]\nimage = \"../shared/sky.png\"\n";
        here("dioptre render own/p.frag --include shared --size 4x2 -o shared/sky.png");
    }
};

} // namespace

TEST_F(Include, ShadersAndScenesOfAnotherFolder_AreDrawnOnlyWithIt)
{
    EXPECT_TRUE(std::filesystem::exists(folder / "shared/sky.png"));
    EXPECT_EQ(here("dioptre render own/s.toml --size 4x2 --spp 1 -o s.png").code, 65);
    EXPECT_EQ(
        here("dioptre render own/s.toml --include own --include shared/ --size 4x2 --spp 1 -o s.png").code,
        0);
    EXPECT_EQ(here("dioptre render own/p.frag --size 4x2 -o p.png").code, 66);
}

TEST_F(Include, Bench_HandsItToItsColdStarts)
{
    const auto outcome =
        here("dioptre bench own/s.toml own/p.frag --include shared --size 4x2 --frames 1 --cold 1 --json");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
}
