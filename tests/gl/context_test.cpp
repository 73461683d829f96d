#include "base/error.h"
#include "gl/context.h"
#include "gl/program.h"
#include "gl/target.h"
#include "gl/texture.h"
#include "support/display.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <memory>

namespace dioptre
{
namespace
{

const std::string constantShader = R"(#version 330 core
layout(location = 0) out vec4 colour;
void main() { colour = vec4(1.5, -0.25, gl_FragCoord.xy); }
)";

std::vector<float> texel(const Picture& picture, int x, int y)
{
    const auto first = picture.floats.begin() + 4 * (y * picture.width + x);
    return {first, first + 4};
}

// Each backend of this machine in turn, in one process: the functions are loaded anew for each.
class EachBackend : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        if (GetParam() != "window")
            return;
        display_ = std::make_unique<test::VirtualDisplay>();
        setenv("DISPLAY", display_->name().c_str(), 1);
    }
    void TearDown() override
    {
        if (display_ != nullptr)
            unsetenv("DISPLAY");
    }

private:
    std::unique_ptr<test::VirtualDisplay> display_;
};

INSTANTIATE_TEST_SUITE_P(Gl, EachBackend,
                         testing::Values("egl-surfaceless", "egl-device", "osmesa", "window",
                                         "egl-surfaceless"),
                         [](const auto& info) {
                             std::string name = info.param + std::to_string(info.index);
                             std::erase(name, '-');
                             return name;
                         });

TEST_P(EachBackend, SaysWhatItIs)
{
    const auto context = makeContext(GetParam());
    EXPECT_EQ(context->info().backend, GetParam());
    EXPECT_FALSE(context->info().renderer.empty());
    EXPECT_GE(std::stod(context->info().version), 3.3);
    const bool isLlvmpipe = context->info().renderer.find("llvmpipe") != std::string::npos;
    EXPECT_TRUE(context->info().software || !isLlvmpipe);
}

TEST_P(EachBackend, NewTarget_IsZero)
{
    const auto context = makeContext(GetParam());
    const AccumulationTarget target = makeAccumulationTarget(3, 2);
    EXPECT_EQ(readBack(target).floats, std::vector<float>(4 * 3 * 2, 0.0f));
}

TEST_P(EachBackend, DrawAdding_AddsFloatsInsideItsRectangleAlone)
{
    const auto context = makeContext(GetParam());
    const AccumulationTarget target = makeAccumulationTarget(5, 4);
    const Program program = buildProgram(constantShader);
    glUseProgram(program.name.name());
    drawAdding(target, 1, 2, 3, 2);
    drawAdding(target, 1, 2, 1, 1);
    const Picture picture = readBack(target);
    EXPECT_EQ(texel(picture, 1, 2),
              (std::vector<float>{3.0f, -0.5f, 3.0f, 5.0f})); // two draws; centres at .5
    EXPECT_EQ(texel(picture, 3, 3), (std::vector<float>{1.5f, -0.25f, 3.5f, 3.5f}));
    for (const auto& [x, y] : {std::pair{0, 2}, {4, 2}, {1, 1}, {3, 1}})
        EXPECT_EQ(texel(picture, x, y), (std::vector<float>(4, 0.0f))) << x << " " << y;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(EachBackend, OneContextAfterAnother_Works)
{
    auto context = makeContext(GetParam());
    for (int round = 0; round < 3; ++round) {
        context.reset();
        context = makeContext(GetParam());
        const AccumulationTarget target = makeAccumulationTarget(1, 1);
        const Program program = buildProgram(constantShader);
        glUseProgram(program.name.name());
        drawAdding(target, 0, 0, 1, 1);
        EXPECT_EQ(texel(readBack(target), 0, 0), (std::vector<float>{1.5f, -0.25f, 0.5f, 0.5f}));
    }
}

TEST(MakeContext, Auto_NamesItsAttempts)
{
    std::vector<BackendAttempt> attempts;
    const auto context = makeContext("auto", &attempts);
    ASSERT_FALSE(attempts.empty());
    EXPECT_EQ(attempts.front().backend, "egl-surfaceless");
    EXPECT_EQ(attempts.back().backend, context->info().backend);
    EXPECT_EQ(attempts.back().outcome, "");
}

TEST(MakeContext, Window_IsPartOfNoOtherName)
{
    for (const BackendChoice& choice : backendChoices())
        EXPECT_EQ(choice.name == "window",
                  std::find(choice.tries.begin(), choice.tries.end(), "window") != choice.tries.end())
            << choice.name;
}

TEST(MakeContext, WindowWithoutDisplay_IsAbsentAndNamesTheDisplay)
{
    unsetenv("DISPLAY");
    for (int round = 0; round < 2; ++round) {
        std::vector<BackendAttempt> attempts;
        try {
            makeContext("window", &attempts);
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::noOpenGl);
            EXPECT_NE(std::string(error.what()).find("DISPLAY environment variable is missing"),
                      std::string::npos)
                << error.what();
            EXPECT_NE(std::string(error.what()).find("xvfb-run -a"), std::string::npos) << error.what();
        }
        ASSERT_EQ(attempts.size(), 1U);
        EXPECT_TRUE(attempts[0].absent);
    }
}

TEST(MakeContext, UnknownName_IsUsageWithAMend)
{
    try {
        makeContext("osmessa");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("did you mean 'osmesa'?"), std::string::npos)
            << error.what();
    }
}

// In a process of their own, since EGL reads this setting once: the directory of its drivers is gone, as on a
// machine that has none.
class WithoutEglDrivers : public testing::Test
{
protected:
    void SetUp() override
    {
        testing::FLAGS_gtest_death_test_style = "threadsafe";
    }
};

TEST_F(WithoutEglDrivers, Auto_FallsBackToOsmesa)
{
    const auto attempt = [] {
        setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
        std::vector<BackendAttempt> attempts;
        const auto context = makeContext("auto", &attempts);
        for (const BackendAttempt& each : attempts)
            std::cerr << each.backend << (each.outcome.empty() ? " works;" : " fails;");
        std::_Exit(0);
    };
    EXPECT_EXIT(attempt(), testing::ExitedWithCode(0),
                "egl-surfaceless fails;egl-device fails;egl-default fails;osmesa works;");
}

TEST_F(WithoutEglDrivers, Egl_IsNoOpenGlAndNamesEveryAttempt)
{
    const auto attempt = [] {
        setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
        try {
            makeContext("egl");
        } catch (const Error& error) {
            std::cerr << error.what();
            std::_Exit(static_cast<int>(error.code()));
        }
        std::_Exit(0);
    };
    EXPECT_EXIT(attempt(), testing::ExitedWithCode(69),
                "egl-surfaceless: .*; egl-device: .*; egl-default: .*install");
}

// With a context for the whole test.
class Gl : public testing::Test
{
protected:
    std::unique_ptr<Context> context_ = makeContext("auto");
};

TEST_F(Gl, OversizedTarget_IsUsage)
{
    for (const int width : {0, 1 << 20}) {
        try {
            makeAccumulationTarget(width, 1);
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
        }
    }
}

TEST_F(Gl, CompileError_NamesTheLineThatWasSent)
{
    try {
        buildProgram("#version 330 core\nout vec4 colour;\nvoid main() {\n    colour = vec4(absent);\n}\n");
        FAIL();
    } catch (const ShaderError& error) {
        ASSERT_FALSE(error.messages.empty());
        EXPECT_EQ(error.messages[0].line, 4);
        EXPECT_NE(error.messages[0].text.find("absent"), std::string::npos);
    }
}

// A function that is declared and called but nowhere defined is found out by the linker.
TEST_F(Gl, LinkError_IsReported)
{
    try {
        buildProgram("#version 330 core\nout vec4 colour;\nvec4 f();\nvoid main() { colour = f(); }\n");
        FAIL();
    } catch (const ShaderError& error) {
        ASSERT_FALSE(error.messages.empty());
        EXPECT_NE(error.messages[0].text, "");
    }
}

TEST_F(Gl, Uniforms_AreTheActiveOnesOutsideBlocks)
{
    const Program program = buildProgram(R"(#version 330 core
layout(std140) uniform Lights { vec4 position[2]; };
uniform float u_gain;
uniform float u_steps[3];
uniform vec4 u_unused;
out vec4 colour;
void main() { colour = position[1] * u_gain + u_steps[2] + gl_FragCoord; }
)");
    std::vector<std::string> names;
    for (const auto& [name, location] : program.uniforms) {
        names.push_back(name);
        EXPECT_EQ(location, glGetUniformLocation(program.name.name(), name.c_str()));
    }
    EXPECT_EQ(names, (std::vector<std::string>{"u_gain", "u_steps"}));
    ASSERT_EQ(program.uniformBlocks.size(), 1u);
    EXPECT_EQ(program.uniformBlocks.at("Lights"), glGetUniformBlockIndex(program.name.name(), "Lights"));
}

// Draws one texel of `expression`, with the texture on unit 0 and the buffer at binding 0.
std::vector<float> evaluate(const std::string& declaration, const std::string& expression)
{
    const Program program = buildProgram("#version 330 core\n" + declaration +
                                         "out vec4 colour;\nvoid main() { colour = " + expression + "; }\n");
    const AccumulationTarget target = makeAccumulationTarget(1, 1);
    glUseProgram(program.name.name());
    drawAdding(target, 0, 0, 1, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return texel(readBack(target), 0, 0);
}

TEST_F(Gl, PictureArray_HoldsTheLevelsAsGivenAndDecodesSrgb)
{
    const auto grey = [](int side, std::uint8_t code) {
        return Picture{side,
                       side,
                       PixelFormat::srgb8,
                       std::vector<std::uint8_t>(4 * static_cast<std::size_t>(side * side), code),
                       {}};
    };
    const std::vector<Picture> below = {grey(2, 255), grey(1, 0)};
    const std::vector<Picture> above = {grey(2, 188), grey(1, 255)};
    const Texture texture = uploadPictureArray({below, above});
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    const std::string declaration = "uniform sampler2DArray pictures;\n";
    EXPECT_EQ(evaluate(declaration, "textureLod(pictures, vec3(0.3, 0.7, 0.0), 0.0)")[0], 1.0f);
    EXPECT_EQ(evaluate(declaration, "textureLod(pictures, vec3(0.3, 0.7, 0.0), 1.0)")[0], 0.0f);
    EXPECT_EQ(evaluate(declaration, "textureLod(pictures, vec3(0.3, 0.7, 1.0), 1.0)")[0], 1.0f);
    const auto decoded =
        evaluate(declaration, "textureLod(pictures, vec3(2.3, -0.7, 1.0), 0.0)"); // repeats both ways
    EXPECT_NEAR(decoded[0], linearFromSrgb8(188), 2e-3f);
    EXPECT_NEAR(decoded[3], 188.0f / 255.0f, 1e-5f); // alpha is linear
    EXPECT_NEAR(evaluate(declaration, "textureLod(pictures, vec3(0.5, 0.5, 0.0), 0.5)")[0], 0.5f,
                0.01f); // trilinear
}

// Two texels wide and two high: row 0 is the bottom, s repeats, t clamps.
TEST_F(Gl, Sky_IsFloatBottomUpRepeatingAlongSAndClampedAlongT)
{
    const Picture sky{2, 2, PixelFormat::float32, {}, {1e5f, 0, 0, 1, 2, 0, 0, 1, 3, 0, 0, 1, 4, 0, 0, 1}};
    const Texture texture = uploadSky(sky);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    const std::string declaration = "uniform sampler2D sky;\n";
    EXPECT_EQ(evaluate(declaration, "textureLod(sky, vec2(0.25, 0.25), 0.0)")[0], 1e5f);
    EXPECT_EQ(evaluate(declaration, "textureLod(sky, vec2(1.75, 0.75), 0.0)")[0], 4.0f);
    EXPECT_EQ(evaluate(declaration, "textureLod(sky, vec2(0.75, -9.0), 0.0)")[0], 2.0f);
    EXPECT_EQ(evaluate(declaration, "textureLod(sky, vec2(0.0, 9.0), 0.0)")[0], 3.5f); // the seam, filtered
}

TEST_F(Gl, UniformBuffer_HoldsTheNumbers)
{
    const Buffer buffer = uploadUniformBuffer({1, 2, 3, 4, 5, 6, 7, 8});
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer.name());
    EXPECT_EQ(evaluate("layout(std140) uniform Values { vec4 value[2]; };\n", "value[1]"),
              (std::vector<float>{5, 6, 7, 8}));
}

} // namespace
} // namespace dioptre
