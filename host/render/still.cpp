#include "render/still.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "gl/program.h"
#include "gl/target.h"
#include "render/build.h"
#include "render/preprocess.h"
#include "render/renderer.h"
#include "render/view_picture.h"

#include <bit>
#include <cmath>

namespace dioptre
{
namespace
{

// The finite test by bits, as shaders and fast-math builds would need it; counts pixels that fail it.
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

// A #version line that names no other language than ours is left out: the host writes its own first line.
SourceText withoutVersion(SourceText source)
{
    for (auto& line : source) {
        if (line.text.find("#version") != 0)
            continue;
        if (line.text.find("330") == std::string::npos)
            fail(ExitCode::badInput, {line.file, line.line, 1},
                 "'" + line.text + "' is not the version that dioptre runs",
                 "write #version 330 core, or no such line");
        line.text.clear();
    }
    return source;
}

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

Still renderPlain(const std::filesystem::path& shader, const StillSettings& settings)
{
    Still still;
    Stopwatch watch;
    PreprocessInput input;
    input.folder = settings.glslFolder;
    SourceText body = preprocess(withoutVersion(linesOf(readFile(shader), shader.string())), input);
    still.shader = linesOf("#version 330 core", "generated");
    still.shader.insert(still.shader.end(), body.begin(), body.end());
    const auto target = makeAccumulationTarget(settings.width, settings.height);
    still.phases.load = watch.lap_ms();

    const Program program = buildProgram(still.shader);
    still.phases.compile = watch.lap_ms();
    glUseProgram(program.name.name());
    for (const auto& [name, location] : program.uniforms) {
        if (name == "u_resolution")
            glUniform2f(location, static_cast<float>(settings.width), static_cast<float>(settings.height));
        else if (name == "u_time")
            glUniform1f(location, static_cast<float>(settings.time_s));
        else
            fail(ExitCode::badInput, {shader.string(), 0, 0}, "nothing feeds the uniform " + name,
                 "a plain shader is fed u_resolution and u_time");
    }
    drawAdding(target, 0, 0, settings.width, settings.height);
    glFinish();
    still.phases.draw = watch.lap_ms();
    still.picture = readBack(target);
    still.nonfinite = countNonfinite(still.picture);
    still.phases.read = watch.lap_ms();
    still.uniforms = keysOf(program.uniforms);
    return still;
}

} // namespace dioptre
