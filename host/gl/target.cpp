#include "gl/target.h"

#include "base/error.h"
#include "gl/texture_binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace dioptre
{
namespace
{

// Names made by a glGen* function.
template <typename Owner, typename Generate>
Owner generate(Generate generateNames)
{
    GLuint name = 0;
    generateNames(1, &name);
    return Owner(name);
}

void checkSize(int width, int height)
{
    const int longest = longestTargetSide();
    if (width < 1 || height < 1 || width > longest || height > longest)
        fail(ExitCode::usage, fmt::format("pictures of {}x{} pixels cannot be drawn here", width, height),
             fmt::format("choose a --size of 1 to {} on either side", longest));
}

} // namespace

AccumulationTarget makeAccumulationTarget(int width, int height)
{
    checkSize(width, height);
    AccumulationTarget target{width, height, generate<Texture>(glGenTextures),
                              generate<Framebuffer>(glGenFramebuffers),
                              generate<VertexArray>(glGenVertexArrays)};
    const TextureBinding binding(GL_TEXTURE_2D, target.colour.name());
    while (glGetError() != GL_NO_ERROR) {
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    if (glGetError() == GL_OUT_OF_MEMORY)
        fail(ExitCode::retry, fmt::format("the driver has no memory for {}x{} pixels", width, height),
             "draw a smaller --size");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0); // complete without mip levels
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour.name(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail(ExitCode::noOpenGl, "this OpenGL cannot draw into float32 textures", "try another --backend");
    glViewport(0, 0, width, height);
    clear(target);
    return target;
}

void clear(const AccumulationTarget& target)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glDisable(GL_SCISSOR_TEST);
    const std::array<GLfloat, 4> zero{};
    glClearBufferfv(GL_COLOR, 0, zero.data());
}

void drawReplacing(const AccumulationTarget& target)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glViewport(0, 0, target.width, target.height);
    glBindVertexArray(target.vertexArray.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Draws add up in the order in which they are made: OpenGL blends in that order.
void drawAdding(const AccumulationTarget& target, int x, int y, int width, int height)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glViewport(0, 0, target.width, target.height);
    glBindVertexArray(target.vertexArray.name());
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

void readBackInto(Picture& picture, int x, int y, const AccumulationTarget& target, int width, int height)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, picture.width);
    const auto first =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, &picture.floats[4 * first]);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

Picture readBack(const AccumulationTarget& target)
{
    Picture picture = blankFloats(target.width, target.height);
    readBackInto(picture, 0, 0, target, target.width, target.height);
    return picture;
}

int longestTargetSide()
{
    GLint longestTexture = 0;
    std::array<GLint, 2> longestViewport{};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longestTexture);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, longestViewport.data());
    return std::min({longestTexture, longestViewport[0], longestViewport[1]});
}

} // namespace dioptre
