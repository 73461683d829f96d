#include "render/plain.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/build.h"
#include "render/samples.h"
#include "render/still.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace dioptre
{
namespace
{

PlainForm formOf(const PlainSettings& plain, const ViewSettings& view, const ContextInfo& context)
{
    PlainForm form;
    std::ranges::transform(plain.channels, form.channels.begin(), &ChannelSource::kind);
    form.inTiles = targetWidth(view) < view.width || targetHeight(view) < view.height;
    form.loopsMayBeEnded = context.software;
    return form;
}

std::size_t countEnded(const Picture& picture)
{
    std::size_t count = 0;
    for (const float number : picture.floats)
        count += std::bit_cast<std::uint32_t>(number) == loopsWereEnded ? 1 : 0;
    return count;
}

} // namespace

void startVariablesAtZero()
{
    ::setenv("glsl_zero_init", "true", 0);
    ::setenv("MESA_DEBUG", "silent", 0); // or Mesa says on standard error that it heard
}

PlainRenderer::PlainRenderer(const std::filesystem::path& shader, const ViewSettings& view,
                             PlainSettings plain, const ContextInfo& context)
    : Drawing(targetWidth(view), targetHeight(view), view.drawLimit_s), shader_(shader),
      plain_(std::move(plain)), size_px_(view.width, view.height)
{
    Stopwatch watch;
    const PlainForm form = formOf(plain_, view, context);
    const SearchPlaces places{plain_.included, view.glslFolder};
    text_ = assemblePlain(shader, places, form);
    std::ranges::transform(plain_.channels, channels_.begin(), makeChannel);
    times_.load = watch.lap_ms();
    build(form, places);
    times_.compile = watch.lap_ms();
    glUseProgram(program_.name.name());
    uniforms_ = feedOnce(program_, numbers(), plain_.values, shader_, text_.text);
    bind();
    drawFirst();
    waitForFirst();
    times_.firstDraw = watch.lap_ms();
}

// The check of loops may fail where the shader would not: its text is not looked at as closely as a compiler
// does.
void PlainRenderer::build(PlainForm form, const SearchPlaces& places)
{
    try {
        program_ = buildProgram(text_.text);
    } catch (const Error&) {
        if (!text_.checksLoops)
            throw;
        form.loopsMayBeEnded = false;
        text_ = assemblePlain(shader_, places, form);
        program_ = buildProgram(text_.text);
    }
    if (text_.checksLoops && !text_.discards && !program_.uniforms.contains(loopCheckUniform))
        fail(ExitCode::badInput, {shader_.string()}, "it has a loop that never ends: no pixel is ever done",
             "give the loop a condition, or a break that is reached");
}

void PlainRenderer::moveTo(const PlainFrame& frame)
{
    plain_.frame = frame;
}

HostNumbers PlainRenderer::numbers() const
{
    std::array<glm::ivec2, 4> sizes_px;
    std::ranges::transform(channels_, sizes_px.begin(), &Channel::size_px);
    HostNumbers numbers = hostUniforms(plain_.frame, size_px_.x, size_px_.y, sizes_px);
    numbers[tileOriginUniform] = {static_cast<double>(region_.x), static_cast<double>(region_.y)};
    numbers[loopCheckUniform] = {2.0};
    return numbers;
}

void PlainRenderer::bind() const
{
    glUseProgram(program_.name.name());
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(channels_[i].target, channels_[i].texture.name());
    }
    feedFrame(uniforms_, numbers(), shader_);
}

void PlainRenderer::drawRegion()
{
    bind();
    cover(region_);
}

long PlainRenderer::passes() const
{
    return 1;
}

PixelCounts PlainRenderer::finish(Picture& picture) const
{
    const std::size_t ended = text_.checksLoops ? countEnded(picture) : 0;
    if (ended > 0)
        fail(ExitCode::badInput, {shader_.string()},
             fmt::format("this software driver ended the loops of {} pixels after {} iterations", ended,
                         softwareLoopCap),
             "look for a loop that does not end, or needs fewer iterations, or draw on a graphics card");
    return {0.0, countNonfinite(picture)};
}

DrawingFacts PlainRenderer::facts() const
{
    DrawingFacts facts;
    facts.shader = text_.text;
    facts.uniforms = keysOf(program_.uniforms);
    return facts;
}

} // namespace dioptre
