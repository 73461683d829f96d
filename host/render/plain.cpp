#include "render/plain.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/build.h"

#include <algorithm>
#include <cstdlib>

namespace dioptre
{
namespace
{

std::array<ChannelKind, 4> kindsOf(const PlainSettings& plain)
{
    std::array<ChannelKind, 4> kinds{};
    std::ranges::transform(plain.channels, kinds.begin(), &ChannelSource::kind);
    return kinds;
}

} // namespace

void startVariablesAtZero()
{
    ::setenv("glsl_zero_init", "true", 0);
    ::setenv("MESA_DEBUG", "silent", 0); // or Mesa says on standard error that it heard
}

PlainRenderer::PlainRenderer(const std::filesystem::path& shader, const ViewSettings& view,
                             PlainSettings plain)
    : shader_(shader), plain_(std::move(plain))
{
    Stopwatch watch;
    text_ = assemblePlain(shader, view.glslFolder, kindsOf(plain_)).text;
    std::ranges::transform(plain_.channels, channels_.begin(), makeChannel);
    target_ = makeAccumulationTarget(view.width, view.height);
    times_.load = watch.lap_ms();
    program_ = buildProgram(text_);
    times_.compile = watch.lap_ms();
    glUseProgram(program_.name.name());
    uniforms_ = feedOnce(program_, numbers(), plain_.values, shader_, text_);
    bind();
    drawAdding(target_, 0, 0, 1, 1); // makes the driver compile
    glFinish();
    times_.firstDraw = watch.lap_ms();
}

void PlainRenderer::moveTo(const PlainFrame& frame)
{
    plain_.frame = frame;
}

HostNumbers PlainRenderer::numbers() const
{
    std::array<glm::ivec2, 4> sizes_px;
    std::ranges::transform(channels_, sizes_px.begin(), &Channel::size_px);
    return hostUniforms(plain_.frame, target_.width, target_.height, sizes_px);
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

// Scissored draws bound the time of each.
void PlainRenderer::submit(const std::function<void(double)>& progress)
{
    constexpr int tile_px = 512;
    const double total = static_cast<double>(target_.width) * target_.height;
    double done = 0.0;
    clear(target_);
    bind();
    for (int y = 0; y < target_.height; y += tile_px) {
        for (int x = 0; x < target_.width; x += tile_px) {
            const int width = std::min(tile_px, target_.width - x);
            const int height = std::min(tile_px, target_.height - y);
            drawAdding(target_, x, y, width, height);
            done += static_cast<double>(width) * height;
            if (progress) {
                glFinish();
                progress(done / total);
            }
        }
    }
}

Picture PlainRenderer::read() const
{
    return readBack(target_);
}

Still drawPlain(PlainRenderer& renderer, const std::function<void(double)>& progress)
{
    Still still;
    Stopwatch watch;
    renderer.draw(progress);
    still.phases.draw = watch.lap_ms();
    still.picture = renderer.read();
    still.nonfinite = countNonfinite(still.picture);
    still.phases.read = watch.lap_ms();
    still.shader = renderer.text();
    still.uniforms = keysOf(renderer.program().uniforms);
    return still;
}

Still renderPlain(const std::filesystem::path& shader, const StillSettings& settings,
                  const PlainSettings& plain)
{
    PlainRenderer renderer(shader, settings, plain);
    Still still = drawPlain(renderer, settings.progress);
    still.phases.load = renderer.times().load;
    still.phases.compile = renderer.times().compile;
    still.phases.firstDraw = renderer.times().firstDraw;
    return still;
}

} // namespace dioptre
