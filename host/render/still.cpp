#include "render/still.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/renderer.h"
#include "render/view_picture.h"

#include <bit>
#include <cmath>

namespace dioptre
{
namespace
{

std::vector<DrawnPart> drawnParts(const Renderer& renderer, const ViewSettings& view)
{
    std::vector<DrawnPart> parts;
    for (const auto& program : renderer.parts()) {
        double pixels = 0.0;
        for (const auto& r : program.part.rectangles)
            pixels += static_cast<double>(r.width) * r.height;
        parts.push_back({program.part.name, pixels / view.width / view.height, program.part.rectangles.size(),
                         program.plan, program.shader});
    }
    return parts;
}

} // namespace

// The finite test by bits, as shaders and fast-math builds would need it.
std::size_t countNonfinite(const Picture& picture)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.floats.size(); i += 4) {
        const auto bad = [&](std::size_t c) {
            return (std::bit_cast<std::uint32_t>(picture.floats[i + c]) & 0x7F800000U) == 0x7F800000U;
        };
        count += bad(0) || bad(1) || bad(2) ? 1 : 0;
    }
    return count;
}

void finish(Still& still, float scale, double raysScale)
{
    double rays = 0.0;
    auto& values = still.picture.floats;
    for (std::size_t i = 0; i < values.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            values[i + c] *= scale;
        rays += static_cast<double>(values[i + 3]);
        values[i + 3] = 1.0F;
    }
    still.raysPerSample = rays * raysScale / (static_cast<double>(values.size()) / 4.0);
    still.nonfinite = countNonfinite(still.picture);
}

Still drawFrame(Renderer& renderer, const StillSettings& settings)
{
    Still still;
    Stopwatch watch;
    renderer.draw(settings.progress);
    still.phases.draw = watch.lap_ms();
    still.picture = renderer.read();
    if (settings.view != DataView::none)
        dataFromSums(still.picture, settings.view, settings.samples);
    finish(still, 1.0F / static_cast<float>(settings.samples), 1.0 / settings.samples);
    still.phases.read = watch.lap_ms();
    return still;
}

Still renderScene(const PreparedScene& prepared, const StillSettings& settings, const ContextInfo& context)
{
    Renderer renderer(prepared, settings, context);
    Still still = drawFrame(renderer, settings);
    still.phases.load = renderer.times().load;
    still.phases.compile = renderer.times().compile;
    still.phases.firstDraw = renderer.times().firstDraw;

    const PartProgram& fullest = renderer.parts().back();
    still.shader = fullest.shader;
    still.uniforms = keysOf(fullest.program.uniforms);
    still.blocks = keysOf(fullest.program.uniformBlocks);
    still.parts = drawnParts(renderer, settings);
    still.textureBytes = renderer.device().textureBytes;
    for (const auto& texture : renderer.device().textures)
        still.textures.push_back(texture.uniform);
    return still;
}

} // namespace dioptre
