// The assembled shaders themselves: valid by an independent compiler, and nothing in them that is not used.
#include "support/process.h"
#include "support/rendering.h"

#include "base/file.h"
#include "render/device_scene.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class GalleryShader : public testing::TestWithParam<std::filesystem::path>
{
protected:
    SourceText shaderOf(const std::vector<std::string>& overrides) const
    {
        const ViewSettings settings{64, 36, 1, glslFolder()};
        const auto prepared = prepare(loadScene(GetParam(), overrides), settings);
        return assemble(prepared.scene, prepared.plan, prepared.packed, settings.glslFolder);
    }
};

INSTANTIATE_TEST_SUITE_P(Scenes, GalleryShader, testing::ValuesIn(galleryScenes()),
                         [](const auto& info) { return info.param.stem().string(); });

const std::vector<std::vector<std::string>> variants = {
    {}, {"trace.form=loop"}, {"trace.order=breadth-first"}, {"trace.light_type=0"}, {"trace.light_type=2"}};

// Bodies of the functions of a shader, by name. It reads the text on its own, not by the pruner that is under
// test: a definition starts in the first column with "type name(" and ends with the first "}" in that column.
std::map<std::string, std::string> functionBodies(const std::string& shader)
{
    const std::string text = std::regex_replace(shader, std::regex("//[^\n]*"), "");
    const std::regex definition("(^|\n)(?!struct|layout|uniform|const|out|#)\\w+ (\\w+)\\([^;{]*\\)\\s*\\{");
    std::map<std::string, std::string> bodies;
    for (std::sregex_iterator found(text.begin(), text.end(), definition), end; found != end; ++found) {
        const auto start = static_cast<std::size_t>(found->position() + found->length());
        bodies[(*found)[2]] = text.substr(start, text.find("\n}", start) - start);
    }
    return bodies;
}

// Functions that main() reaches by calls.
std::set<std::string> reachedFromMain(const std::map<std::string, std::string>& bodies)
{
    const std::regex call("\\b(\\w+)\\s*\\(");
    std::set<std::string> reached = {"main"};
    std::vector<std::string> open = {"main"};
    while (!open.empty()) {
        const auto body = bodies.at(open.back());
        open.pop_back();
        for (std::sregex_iterator found(body.begin(), body.end(), call), end; found != end; ++found) {
            const std::string name = (*found)[1];
            if (bodies.contains(name) && reached.insert(name).second)
                open.push_back(name);
        }
    }
    return reached;
}

} // namespace

TEST_P(GalleryShader, GlslangValidator_AcceptsItAsGlsl330)
{
    for (const auto& overrides : variants) {
        const auto file =
            std::filesystem::temp_directory_path() /
            ("dioptre-" + std::to_string(getpid()) + "-" + GetParam().stem().string() + ".frag");
        std::ofstream(file) << flatten(shaderOf(overrides));
        const auto outcome = run("glslangValidator -C '" + file.string() + "'");
        EXPECT_EQ(outcome.code, 0) << outcome.out;
        std::filesystem::remove(file);
    }
}

TEST_P(GalleryShader, EveryFunction_IsCalled)
{
    for (const auto& overrides : variants) {
        const auto bodies = functionBodies(flatten(shaderOf(overrides)));
        const auto reached = reachedFromMain(bodies);
        ASSERT_GT(reached.size(), 20U);
        for (const auto& [name, body] : bodies)
            EXPECT_TRUE(reached.contains(name)) << name << " is never called";
    }
}

TEST_P(GalleryShader, ActiveUniforms_AreThoseOfThePlan)
{
    // renderScene() compares both ways and throws where they differ.
    for (const auto& overrides : variants)
        EXPECT_NO_THROW(test::renderScene(GetParam(), {16, 9, 1, overrides, "auto"}));
}

TEST_P(GalleryShader, Text_IsTheSameEachTime)
{
    EXPECT_EQ(flatten(shaderOf({})), flatten(shaderOf({})));
}

TEST(ShaderErrors, AnEditedFile_IsNamedWithItsLine)
{
    const auto folder =
        std::filesystem::temp_directory_path() / ("dioptre-edited-glsl-" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::copy(glslFolder(), folder, std::filesystem::copy_options::recursive);
    auto text = readFile(folder / "trace" / "sky.glsl");
    text.replace(text.find("vec3 radiance"), 13, "vec3 radianc3");
    std::ofstream(folder / "trace" / "sky.glsl") << text;
    contextFor("auto");
    const StillSettings settings{{16, 9, 1, folder}, {}};
    try {
        renderScene(prepare(loadScene(galleryScenes().front(), {}), settings), settings, contextFor("auto"));
        FAIL() << "compiled";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        EXPECT_NE(std::string(error.what()).find("trace/sky.glsl:"), std::string::npos) << error.what();
    }
    std::filesystem::remove_all(folder);
}

TEST(ShaderErrors, AUniformThatNothingFeeds_IsReported)
{
    const auto folder =
        std::filesystem::temp_directory_path() / ("dioptre-unfed-glsl-" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::copy(glslFolder(), folder, std::filesystem::copy_options::recursive);
    auto text = readFile(folder / "trace" / "sky.glsl");
    text.replace(text.find("vec3 skyRadiance"), 0, "uniform float u_stray;\n\n");
    text.replace(text.find("return radiance"), 15, "return u_stray * radiance");
    std::ofstream(folder / "trace" / "sky.glsl") << text;
    const StillSettings settings{{16, 9, 1, folder}, {}};
    try {
        renderScene(prepare(loadScene(galleryScenes().front(), {}), settings), settings, contextFor("auto"));
        FAIL() << "u_stray was not noticed";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("u_stray"), std::string::npos) << error.what();
    }
    std::filesystem::remove_all(folder);
}
