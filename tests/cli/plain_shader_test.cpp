// Shaders from tests/shaders, as they stand: "// options:" is what the command is given, "// expect: x,y = r
// g b" what a pixel of the 8x4 picture must hold, within 1e-5 where nothing else is said.
#include "base/file.h"
#include "base/picture.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

using namespace dioptre;

namespace
{

const std::filesystem::path shaderFolder = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "tests" / "shaders";

std::vector<std::filesystem::path> shaders()
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(shaderFolder))
        paths.push_back(entry.path());
    std::ranges::sort(paths);
    return paths;
}

struct Expected {
    int x = 0;
    int y = 0;
    float colour[3] = {};
    float tolerance = 1e-5F;
};

struct Instructions {
    std::string options;
    std::vector<Expected> pixels;
};

Instructions instructionsOf(const std::filesystem::path& shader)
{
    Instructions found;
    std::istringstream text(readFile(shader));
    for (std::string line; std::getline(text, line);) {
        if (line.ends_with('\r'))
            line.pop_back();
        if (line.starts_with("// options: "))
            found.options = " " + line.substr(12);
        Expected pixel;
        if (std::sscanf(line.c_str(), "// expect: %d,%d = %f %f %f within %f", &pixel.x, &pixel.y,
                        &pixel.colour[0], &pixel.colour[1], &pixel.colour[2], &pixel.tolerance) >= 5)
            found.pixels.push_back(pixel);
    }
    return found;
}

class PlainShader : public test::InAFolder, public testing::WithParamInterface<std::filesystem::path>
{
protected:
    // Pictures for channels, each by a shader of one expression.
    void paint(const std::string& name, const std::string& size, const std::string& colour) const
    {
        std::ofstream(folder / (name + ".frag"))
            << "void mainImage(out vec4 colour, in vec2 p)\n{\n    colour = " << colour << ";\n}\n";
        ASSERT_EQ(here("dioptre render " + name + ".frag --size " + size).code, 0);
    }
    void paintChannels(const std::string& options) const
    {
        if (options.find("quarters.png") != std::string::npos)
            paint("quarters", "2x2", "vec4(step(1.0, p.x), step(1.0, p.y), 0.2, 1.0)");
        if (options.find("red.png") == std::string::npos)
            return;
        paint("red", "4x4", "vec4(1.0, 0.0, 0.0, 1.0)");
        paint("green", "4x4", "vec4(0.0, 1.0, 0.0, 1.0)");
        paint("blue", "4x4", "vec4(0.0, 0.0, 1.0, 1.0)");
        paint("black", "4x4", "vec4(0.0)");
    }
};

INSTANTIATE_TEST_SUITE_P(Shaders, PlainShader, testing::ValuesIn(shaders()),
                         [](const auto& info) { return info.param.stem().string(); });

} // namespace

TEST_P(PlainShader, Unchanged_DrawsWhatItsCommentsDerive)
{
    const auto instructions = instructionsOf(GetParam());
    ASSERT_FALSE(instructions.pixels.empty());
    paintChannels(instructions.options);
    const auto outcome =
        here("dioptre render '" + GetParam().string() + "' --size 8x4 -o a.exr" + instructions.options);
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    const auto picture = readPicture(folder / "a.exr");
    for (const auto& pixel : instructions.pixels) {
        const auto at = 4 * static_cast<std::size_t>(pixel.y * picture.width + pixel.x);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(picture.floats[at + c], pixel.colour[c], pixel.tolerance)
                << "channel " << c << " of pixel " << pixel.x << "," << pixel.y;
    }
}
