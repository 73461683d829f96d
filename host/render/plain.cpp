#include "render/plain.h"

#include "base/clock.h"
#include "base/text.h"
#include "gl/target.h"
#include "render/build.h"

#include <algorithm>
#include <cstdlib>

namespace dioptre
{
namespace
{

// Scissored draws bound the time of each.
void drawAll(const AccumulationTarget& target, const std::function<void(double)>& progress)
{
    constexpr int tile_px = 512;
    double done = 0.0;
    for (int y = 0; y < target.height; y += tile_px) {
        for (int x = 0; x < target.width; x += tile_px) {
            const int width = std::min(tile_px, target.width - x);
            const int height = std::min(tile_px, target.height - y);
            drawAdding(target, x, y, width, height);
            done += static_cast<double>(width) * height;
            if (progress) {
                glFinish();
                progress(done / target.width / target.height);
            }
        }
    }
    glFinish();
}

} // namespace

void startVariablesAtZero()
{
    ::setenv("glsl_zero_init", "true", 0);
    ::setenv("MESA_DEBUG", "silent", 0); // or Mesa says on standard error that it heard
}

Still renderPlain(const std::filesystem::path& shader, const StillSettings& settings,
                  const PlainSettings& plain)
{
    Still still;
    Stopwatch watch;
    std::array<ChannelKind, 4> kinds{};
    std::ranges::transform(plain.channels, kinds.begin(), &ChannelSource::kind);
    const PlainText text = assemblePlain(shader, settings.glslFolder, kinds);
    still.shader = text.text;
    std::array<Channel, 4> channels;
    std::ranges::transform(plain.channels, channels.begin(), makeChannel);
    const auto target = makeAccumulationTarget(settings.width, settings.height);
    still.phases.load = watch.lap_ms();

    const Program program = buildProgram(still.shader);
    still.phases.compile = watch.lap_ms();
    glUseProgram(program.name.name());
    std::array<glm::ivec2, 4> sizes_px;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        sizes_px[i] = channels[i].size_px;
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(channels[i].target, channels[i].texture.name());
    }
    feed(program, hostUniforms(plain.frame, settings.width, settings.height, sizes_px), plain.values, shader,
         text.text);
    drawAll(target, settings.progress);
    still.phases.draw = watch.lap_ms();
    still.picture = readBack(target);
    still.nonfinite = countNonfinite(still.picture);
    still.phases.read = watch.lap_ms();
    still.uniforms = keysOf(program.uniforms);
    return still;
}

} // namespace dioptre
