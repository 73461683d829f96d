#include "render/shown_picture.h"

#include "gl/texture_binding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre
{
namespace
{

SourceText presentText(const std::filesystem::path& glslFolder)
{
    SourceText text = readSource(glslFolder / "live" / "present.frag");
    text.insert(text.begin(), {"#version 330 core", "generated", 1});
    return text;
}

// As u_gamma of glsl/live/present.frag.
float gammaOf(const std::optional<Display>& display)
{
    return display ? static_cast<float>(display->gamma.value_or(0.0)) : -1.0F;
}

} // namespace

ShownPicture::ShownPicture(const std::filesystem::path& glslFolder)
    : program_(buildProgram(presentText(glslFolder)))
{
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    vertexArray_ = VertexArray(name);
}

void ShownPicture::makeRoom(const glm::ivec2& size_px)
{
    if (size_px == size_px_)
        return;
    TextureShape shape;
    shape.width = size_px.x;
    shape.height = size_px.y;
    colour_ = makeTexture(shape);
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    framebuffer_ = Framebuffer(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
    size_px_ = size_px;
}

void ShownPicture::take(const AccumulationTarget& sums, int samples, const std::optional<Display>& display)
{
    encode(sums, nullptr, 1.0 / samples, display);
}

void ShownPicture::takeDifference(const AccumulationTarget& one, const AccumulationTarget& other, int samples,
                                  double scale, const std::optional<Display>& display)
{
    encode(one, &other, scale / samples, display);
}

// `scale`: of sums to radiance. `other`: of which the difference is shown; null for none.
void ShownPicture::encode(const AccumulationTarget& sums, const AccumulationTarget* other, double scale,
                          const std::optional<Display>& display)
{
    makeRoom({sums.width, sums.height});
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, sums.width, sums.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glUseProgram(program_.name.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, (other != nullptr ? *other : sums).colour.name());
    glActiveTexture(GL_TEXTURE0);
    const TextureBinding binding(GL_TEXTURE_2D, sums.colour.name());
    const double exposure = display ? display->exposure : 0.0;
    const auto locate = [this](const char* uniform) { return program_.uniforms.at(uniform); };
    glUniform1i(locate("u_sums"), 0);
    glUniform1i(locate("u_other_sums"), 1);
    glUniform1i(locate("u_is_difference"), other != nullptr ? 1 : 0);
    glUniform1f(locate("u_scale"), static_cast<float>(std::exp2(exposure) * scale));
    glUniform1i(locate("u_curve"), display ? static_cast<int>(display->curve) : 0);
    glUniform1f(locate("u_gamma"), gammaOf(display));
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

void ShownPicture::take(const Picture& picture)
{
    makeRoom({picture.width, picture.height});
    const auto texels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    std::vector<std::uint8_t> bytes(4 * texels);
    std::ranges::transform(picture.floats, bytes.begin(), [](float number) {
        return static_cast<std::uint8_t>(number > 0.0F ? std::min(number, 1.0F) * 255.0F + 0.5F : 0.0F);
    });
    const TextureBinding binding(GL_TEXTURE_2D, colour_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    bytes.data());
}

void ShownPicture::draw(const glm::ivec2& window_px) const
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    if (size_px_ != window_px) {
        const std::array<GLfloat, 4> black{0.0F, 0.0F, 0.0F, 1.0F};
        glClearBufferfv(GL_COLOR, 0, black.data());
    }
    drawFrom(0, window_px);
}

void ShownPicture::drawFrom(int column, const glm::ivec2& window_px) const
{
    const int width = std::min(size_px_.x, window_px.x), height = std::min(size_px_.y, window_px.y);
    if (column < width) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
        glBlitFramebuffer(column, size_px_.y - height, width, size_px_.y, column, window_px.y - height, width,
                          window_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window_px.x, window_px.y);
}

Picture ShownPicture::read() const
{
    const auto texels = static_cast<std::size_t>(size_px_.x) * static_cast<std::size_t>(size_px_.y);
    Picture picture{size_px_.x, size_px_.y, PixelFormat::srgb8, std::vector<std::uint8_t>(4 * texels), {}};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_px_.x, size_px_.y, GL_RGBA, GL_UNSIGNED_BYTE, picture.bytes.data());
    return picture;
}

} // namespace dioptre
