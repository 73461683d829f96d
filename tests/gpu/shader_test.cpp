// The assembled shaders themselves: valid by an independent compiler, and nothing in them that is not used.
#include "support/declarations.h"
#include "support/glslang.h"
#include "support/rendering.h"

#include "base/file.h"
#include "render/device_scene.h"
#include "render/shared_values.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// Both stages of a scene's program, as the driver gets them.
struct Stages {
    std::string fragment;
    std::string vertex;
};

using Overrides = std::vector<std::string>;

Stages assembled(const std::filesystem::path& scene, const Overrides& overrides)
{
    const ViewSettings settings{64, 36, 1, glslFolder()};
    const auto prepared = prepare(loadScene(scene, overrides, 0.0, places()), settings);
    return {flatten(assemble(prepared.scene, prepared.plan, prepared.packed, settings.glslFolder)),
            flatten(assembleVertex(prepared.plan, prepared.packed, settings.glslFolder))};
}

// Of each part of a picture that has a program of its own.
std::vector<Stages> assembledParts(const std::filesystem::path& scene)
{
    const ViewSettings settings{320, 180, 1, glslFolder()};
    const auto prepared = prepare(loadScene(scene, {"plan.tiles=on"}, 0.0, places()), settings);
    std::vector<Stages> stages;
    for (const auto& part : prepared.parts) {
        const Plan plan = makePlan(prepared.scene, DataView::none, ShaderDevice(), part.seen);
        stages.push_back({flatten(assemble(prepared.scene, plan, prepared.packed, settings.glslFolder)),
                          flatten(assembleVertex(plan, prepared.packed, settings.glslFolder))});
    }
    return stages;
}

class GalleryShader : public testing::TestWithParam<std::filesystem::path>
{
protected:
    // Made once for all tests: the pictures take most of the time.
    static const Stages& stagesOf(const Overrides& overrides)
    {
        static std::map<std::pair<std::filesystem::path, Overrides>, Stages> made;
        const std::pair key(GetParam(), overrides);
        auto found = made.find(key);
        if (found == made.end())
            found = made.emplace(key, assembled(GetParam(), overrides)).first;
        return found->second;
    }
};

INSTANTIATE_TEST_SUITE_P(Scenes, GalleryShader, testing::ValuesIn(galleryScenes()),
                         [](const auto& info) { return info.param.stem().string(); });

const std::vector<Overrides> variants = {
    {},
    {"trace.form=loop"},
    {"trace.order=breadth-first"},
    {"trace.order=depth-first"},
    {"trace.light_type=0"},
    {"trace.light_type=2"},
    {"plan.values=uniforms"},
    {"plan.lookup=table"},
    {"plan.arctangent=built-in"},
    {"plan.pool=always"},
};

std::string nameOf(const Overrides& overrides)
{
    return overrides.empty() ? "as it is" : overrides.front();
}

// GLSL 3.30 as GLSL ES 3.00: the version is another, and the precisions have to be said.
std::string asEs(const std::string& shader)
{
    const std::string version = "#version 330 core\n";
    EXPECT_TRUE(shader.starts_with(version));
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
           "precision highp sampler2DArray;\n" +
           shader.substr(version.size());
}

} // namespace

TEST_P(GalleryShader, GlslangValidator_AcceptsBothStagesAsGlsl330AndAsGlslEs300)
{
    std::map<std::string, std::string> shaders;
    for (const auto& overrides : variants) {
        const auto& stages = stagesOf(overrides);
        shaders[nameOf(overrides) + ".frag"] = stages.fragment;
        shaders[nameOf(overrides) + ".vert"] = stages.vertex;
        shaders[nameOf(overrides) + ", ES.frag"] = asEs(stages.fragment);
        shaders[nameOf(overrides) + ", ES.vert"] = asEs(stages.vertex);
    }
    EXPECT_EQ(complaints(shaders), "");
}

TEST(ShaderComplaints, AFaultThatOnlyEsHas_IsFound)
{
    // GLSL ES turns no int into a float.
    const std::string shader = "#version 330 core\nout vec4 o_sum;\nvoid main()\n{\n    float x = 1;\n"
                               "    o_sum = vec4(x);\n}\n";
    EXPECT_EQ(complaints({{"a.frag", shader}}), "");
    EXPECT_NE(complaints({{"a.frag", shader}, {"b.frag", asEs(shader)}}).find("b.frag"), std::string::npos);
}

TEST(ShaderDeclarations, ThoseThatNothingReads_AreFound)
{
    const std::string used =
        "#version 330 core\nstruct Used\n{\n    vec4 x;\n};\nlayout(std140) uniform A\n{\n"
        "    Used u_a;\n    vec4 u_b;\n};\nout vec4 o;\n\nvoid main()\n{\n    o = u_a.x;\n}\n";
    const std::string unused =
        "#define SEVEN 7\nconst float eight = 8.0;\nuniform float u_nine;\nvec3 ten[SEVEN];\n"
        "layout(std140) uniform B\n{\n    Used u_c[3];\n};\nstruct Eleven\n{\n    vec4 x;\n};\n"
        "float twelve(float x)\n{\n    {\n        x += 1.0;\n    }\n    return x;\n}\n"
        "void receiveShared()\n{\n    ten[0] = vec3(1.0);\n}\n";
    EXPECT_EQ(unusedNames(used), std::set<std::string>());
    EXPECT_EQ(unusedNames(used + unused),
              (std::set<std::string>{"eight", "u_nine", "ten", "u_c", "Eleven", "twelve", "receiveShared"}));
}

TEST_P(GalleryShader, EveryFunction_IsCalled)
{
    for (const auto& overrides : variants) {
        std::map<std::string, std::set<std::string>> mentioned; // by function
        for (const auto& declaration : declarationsOf(stagesOf(overrides).fragment))
            if (declaration.isFunction) {
                const auto words = wordsOf(declaration.text);
                mentioned[*declaration.names.begin()].insert(words.begin(), words.end());
            }
        const auto reached = reachedFromMain(mentioned);
        ASSERT_GT(reached.size(), 20U);
        for (const auto& [name, words] : mentioned)
            EXPECT_TRUE(reached.contains(name)) << name << " is never called, " << nameOf(overrides);
    }
}

TEST_P(GalleryShader, EveryDeclaration_IsUsedInBothStages)
{
    const std::set<std::string> none;
    for (const auto& overrides : variants) {
        EXPECT_EQ(unusedNames(stagesOf(overrides).fragment), none) << nameOf(overrides);
        if (stagesOf(overrides).vertex.find("v_shared") != std::string::npos)
            EXPECT_EQ(unusedNames(stagesOf(overrides).vertex), none) << nameOf(overrides);
        else
            EXPECT_EQ(declarationsOf(stagesOf(overrides).vertex).size(), 1U) << nameOf(overrides);
    }
}

TEST_P(GalleryShader, ActiveUniforms_AreThoseOfThePlan)
{
    // renderScene() compares both ways and throws where they differ.
    for (const auto& overrides : variants)
        EXPECT_NO_THROW(test::renderScene(GetParam(), {16, 9, 1, overrides, "auto"}));
}

TEST_P(GalleryShader, PartsOfThePicture_HaveValidShadersWithNothingUnused)
{
    std::map<std::string, std::string> shaders;
    const auto parts = assembledParts(GetParam());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto name = std::to_string(i);
        shaders[name + ".frag"] = parts[i].fragment;
        shaders[name + ".vert"] = parts[i].vertex;
        shaders[name + "-es.frag"] = asEs(parts[i].fragment);
        shaders[name + "-es.vert"] = asEs(parts[i].vertex);
        EXPECT_EQ(unusedNames(parts[i].fragment), std::set<std::string>()) << parts[i].fragment;
    }
    EXPECT_EQ(complaints(shaders), "");
}

TEST_P(GalleryShader, Text_IsTheSameEachTime)
{
    const auto again = assembled(GetParam(), {});
    EXPECT_EQ(stagesOf({}).fragment, again.fragment);
    EXPECT_EQ(stagesOf({}).vertex, again.vertex);
}

namespace
{

// A copy of glsl/ in which one place of a file is edited.
class EditedSources
{
public:
    EditedSources(const std::string& file, const std::string& from, const std::string& to)
        : folder_(std::filesystem::temp_directory_path() /
                  ("dioptre-edited-glsl-" + std::to_string(getpid())))
    {
        std::filesystem::remove_all(folder_);
        std::filesystem::copy(glslFolder(), folder_, std::filesystem::copy_options::recursive);
        edit(file, from, to);
    }
    EditedSources(const EditedSources&) = delete;
    EditedSources& operator=(const EditedSources&) = delete;
    ~EditedSources()
    {
        std::filesystem::remove_all(folder_);
    }
    void edit(const std::string& file, const std::string& from, const std::string& to) const
    {
        auto text = readFile(folder_ / file);
        text.replace(text.find(from), from.size(), to);
        std::ofstream(folder_ / file) << text;
    }
    // What drawing with them ends with; "" where it ends well. Its text tells each complaint.
    std::string error() const
    {
        const ViewSettings settings{16, 9, 1, folder_};
        try {
            renderPrepared(prepare(loadScene(galleryScenes().front(), {}, 0.0, places()), settings), settings,
                           "auto");
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::badInput);
            for (const auto& [where, what, mend] : error.complaints()) {
                const std::string told = where.path.empty() ? what : describe(where) + ": " + what;
                EXPECT_NE(std::string(error.what()).find(told), std::string::npos) << told;
            }
            return error.what();
        }
    }

private:
    std::filesystem::path folder_;
};

} // namespace

TEST(ShaderErrors, AnEditedFile_IsNamedWithItsLine)
{
    const EditedSources sources("trace/sky.glsl", "vec3 radiance", "vec5 radiance");
    const auto text = readFile(glslFolder() / "trace" / "sky.glsl");
    const auto line =
        1 +
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("radiance =")), '\n');
    const auto error = sources.error();
    EXPECT_NE(error.find("trace/sky.glsl:" + std::to_string(line)), std::string::npos) << error;
}

TEST(ShaderErrors, AFileOfTheVertexStage_IsNamedWithItsLineAndText)
{
    const EditedSources sources("shared/structs.glsl", "vec4 diffuse;", "vec5 diffuse;");
    const auto error = sources.error();
    EXPECT_NE(error.find("shared/structs.glsl:"), std::string::npos) << error;
    EXPECT_NE(error.find("    vec5 diffuse;"), std::string::npos) << error;
}

TEST(ShaderErrors, AUniformThatNothingFeeds_IsReported)
{
    const EditedSources sources("trace/sky.glsl", "vec3 skyRadiance",
                                "uniform float u_stray;\n\nvec3 skyRadiance");
    sources.edit("trace/sky.glsl", "return radiance", "return u_stray * radiance");
    EXPECT_NE(sources.error().find("u_stray"), std::string::npos);
}
