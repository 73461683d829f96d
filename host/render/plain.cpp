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

PlainForm formOf(const PlainSettings& plain, const ViewSettings& view, bool software)
{
    PlainForm form;
    std::ranges::transform(plain.channels, form.channels.begin(), &ChannelSource::kind);
    form.inTiles = targetWidth(view) < view.width || targetHeight(view) < view.height;
    form.loopsMayBeEnded = software;
    return form;
}

} // namespace

void startVariablesAtZero()
{
    ::setenv("glsl_zero_init", "true", 0);
    ::setenv("MESA_DEBUG", "silent", 0); // or Mesa says on standard error that it heard
}

LoadedPlain loadPlain(const std::filesystem::path& shader, const ViewSettings& view,
                      const PlainSettings& plain, bool software)
{
    Stopwatch watch;
    LoadedPlain loaded;
    loaded.shader = shader;
    loaded.form = formOf(plain, view, software);
    loaded.places = {plain.included, view.glslFolder};
    loaded.text = assemblePlain(shader, loaded.places, loaded.form);
    std::ranges::transform(plain.channels, loaded.channels.begin(), loadChannel);
    loaded.load_ms = watch.lap_ms();
    return loaded;
}

void leaveOutLoopCheck(LoadedPlain& loaded)
{
    loaded.form.loopsMayBeEnded = false;
    loaded.text = assemblePlain(loaded.shader, loaded.places, loaded.form);
}

HostNumbers frameNumbers(const PlainFrame& frame, const glm::ivec2& size_px, const glm::ivec2& origin_px,
                         const std::array<glm::ivec2, 4>& channelSizes_px)
{
    HostNumbers numbers = hostUniforms(frame, size_px.x, size_px.y, channelSizes_px);
    numbers[tileOriginUniform] = {static_cast<double>(origin_px.x), static_cast<double>(origin_px.y)};
    numbers[loopCheckUniform] = {2.0};
    return numbers;
}

PlainRenderer::PlainRenderer(const std::filesystem::path& shader, const ViewSettings& view,
                             PlainSettings plain, const ContextInfo& context)
    : PlainRenderer(loadPlain(shader, view, plain, context.software), view,
                    plain) // moved, it might be empty before
{
}

PlainRenderer::PlainRenderer(LoadedPlain loaded, const ViewSettings& view, PlainSettings plain)
    : Drawing(targetWidth(view), targetHeight(view), view.drawLimit_s), loaded_(std::move(loaded)),
      plain_(std::move(plain)), size_px_(view.width, view.height)
{
    Stopwatch watch;
    update(loaded_.channels);
    loaded_.channels = {};
    times_.load = loaded_.load_ms + watch.lap_ms();
    build();
    times_.compile = watch.lap_ms();
    update(plain_.values);
    bind();
    drawFirst();
    waitForFirst();
    times_.firstDraw = watch.lap_ms();
}

void PlainRenderer::build()
{
    try {
        program_ = buildProgram(loaded_.text.text);
    } catch (const Error&) {
        if (!loaded_.text.checksLoops)
            throw;
        leaveOutLoopCheck(loaded_);
        program_ = buildProgram(loaded_.text.text);
    }
    if (loaded_.text.checksLoops && !loaded_.text.discards && !program_.uniforms.contains(loopCheckUniform))
        fail(ExitCode::badInput, {loaded_.shader.string()},
             "it has a loop that never ends: no pixel is ever done",
             "give the loop a condition, or a break that is reached");
}

void PlainRenderer::moveTo(const PlainFrame& frame)
{
    plain_.frame = frame;
}

void PlainRenderer::update(PlainValues values)
{
    glUseProgram(program_.name.name());
    uniforms_ = feedOnce(program_, numbers(), values, loaded_.shader, loaded_.text.text);
    plain_.values = std::move(values);
}

void PlainRenderer::update(const glm::ivec2& size_px)
{
    size_px_ = size_px;
    resize(size_px.x, size_px.y);
}

void PlainRenderer::update(const std::array<ChannelPictures, 4>& channels)
{
    channels_ = {};
    std::ranges::transform(channels, channels_.begin(), uploadChannel);
}

HostNumbers PlainRenderer::numbers() const
{
    std::array<glm::ivec2, 4> sizes_px;
    std::ranges::transform(channels_, sizes_px.begin(), &Channel::size_px);
    return frameNumbers(plain_.frame, size_px_, {region_.x, region_.y}, sizes_px);
}

void PlainRenderer::bind() const
{
    glUseProgram(program_.name.name());
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(channels_[i].target, channels_[i].texture.name());
    }
    feedFrame(uniforms_, numbers(), loaded_.shader);
}

// It has no samples: each batch is the same.
void PlainRenderer::drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area)
{
    bind();
    for (std::size_t i = 0; i < batches.size(); ++i)
        cover(area);
}

std::span<const SampleBatch> PlainRenderer::batches() const
{
    static constexpr SampleBatch one{0, 1};
    return {&one, 1};
}

std::size_t countEndedLoops(const Picture& picture)
{
    std::size_t count = 0;
    for (const float number : picture.floats)
        count += std::bit_cast<std::uint32_t>(number) == loopsWereEnded ? 1 : 0;
    return count;
}

void failForEndedLoops(const std::filesystem::path& shader, std::size_t pixels)
{
    fail(ExitCode::badInput, {shader.string()},
         fmt::format("this software driver ended the loops of {} pixels after {} iterations", pixels,
                     softwareLoopCap),
         "look for a loop that does not end, or needs fewer iterations, or draw on a graphics card");
}

PixelCounts PlainRenderer::finish(Picture& picture) const
{
    const std::size_t ended = loaded_.text.checksLoops ? countEndedLoops(picture) : 0;
    if (ended > 0)
        failForEndedLoops(loaded_.shader, ended);
    return {0.0, countNonfinite(picture)};
}

DrawingFacts PlainRenderer::facts() const
{
    DrawingFacts facts;
    facts.shader = loaded_.text.text;
    facts.uniforms = keysOf(program_.uniforms);
    return facts;
}

} // namespace dioptre
