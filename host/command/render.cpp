#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "base/write_file.h"
#include "command/command.h"
#include "command/frames.h"
#include "command/input.h"
#include "command/plain_options.h"
#include "command/progress.h"
#include "command/render_steps.h"
#include "command/report.h"
#include "command/write_still.h"
#include "kernel/reference.h"
#include "render/layers.h"
#include "render/still.h"
#include "render/view_picture.h"
#include "scene/load.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <future>
#include <limits>

namespace dioptre
{
namespace
{

} // namespace

void refuseBadOptions(const RenderOptions& options, const Input& input)
{
    if (!(std::abs(options.time_s) <= static_cast<double>(std::numeric_limits<float>::max())))
        fail(ExitCode::usage, fmt::format("--time {} is no moment", options.time_s),
             "give a number of seconds that a 32-bit float can hold");
    refuseBadOutput(options, input.plainShader);
    if (input.plainShader && (options.reference || options.budget > 0 || !options.view.empty()))
        fail(ExitCode::usage,
             options.input + " is a plain shader, and --budget, --view and --reference are for scenes",
             "leave them out");
    const bool anyChannel = std::ranges::any_of(options.channels, [](const auto& c) { return !c.empty(); });
    if (!input.plainShader && (anyChannel || !options.mouse.empty()))
        fail(ExitCode::usage,
             options.input + " is a scene, and --channel0 to 3 and --mouse are for plain shaders",
             "leave them out");
    if (options.reference && !options.view.empty())
        fail(ExitCode::usage, "--reference traces light alone, and --view " + options.view + " asks for data",
             "leave one of them out");
    if (!options.shader.empty() && std::filesystem::path(options.shader).lexically_normal() ==
                                       std::filesystem::path(options.output).lexically_normal())
        fail(ExitCode::usage, "-o and --shader both name " + options.output, "name two files");
    if (options.reference && !options.shader.empty())
        fail(ExitCode::usage, "--reference traces without a shader, and --shader asks for one",
             "leave one of them out");
}

namespace
{

void refuseEditedShader(const std::filesystem::path& glsl)
{
    if (shaderFingerprint(glsl) != compiledShaderFingerprint())
        fail(ExitCode::badInput, glsl.string() + " was edited after the reference was compiled from it",
             "build again: the reference speaks only for the sources that it was made from");
}

} // namespace

Still renderReferenceStill(const PreparedScene& prepared, const StillSettings& settings)
{
    refuseEditedShader(settings.glslFolder);
    Still still;
    Stopwatch watch;
    still.picture = renderReference(prepared.packed, settings.width, settings.height, settings.samples);
    finish(still, 1.0F, 1.0);
    still.phases.draw = watch.lap_ms();
    return still;
}

StillSettings stillSettingsOf(const RenderOptions& options)
{
    return {{options.width, options.height, options.samples, glslFolder(), pictureCache(),
             dataViewNamed(options.view)},
            {}};
}

namespace
{

struct Rendering {
    Still still;
    ContextInfo context;
    std::optional<PreparedScene> prepared; // none for a plain shader
    std::vector<ExrLayer> layers;
};

Rendering renderInput(const RenderOptions& options, const Input& input)
{
    StillSettings settings = stillSettingsOf(options);
    settings.progress = terminalProgress();
    Rendering rendering;
    Stopwatch watch;
    std::future<PreparedScene> preparing; // beside the making of the context
    if (!input.plainShader)
        preparing =
            std::async(std::launch::async, [scene = loadScene(input.path, options.overrides, options.time_s),
                                            &settings] { return prepare(scene, settings); });
    double load_ms = watch.lap_ms();
    std::unique_ptr<Context> context;
    const PlainSettings plain = input.plainShader ? plainSettings(options) : PlainSettings{};
    if (input.plainShader)
        startVariablesAtZero();
    if (!options.reference)
        context = makeContext(options.backend);
    const double context_ms = watch.lap_ms();
    if (preparing.valid())
        rendering.prepared = preparing.get();
    load_ms += watch.lap_ms(); // what the making of the context did not hide
    if (options.reference) {
        rendering.context = {"reference", "double precision on the CPU", "", true};
        rendering.still = renderReferenceStill(*rendering.prepared, settings);
    } else {
        rendering.context = context->info();
        rendering.still = rendering.prepared ? renderScene(*rendering.prepared, settings, context->info())
                                             : renderPlain(input.path, settings, plain);
        if (!options.layers.empty())
            rendering.layers =
                drawLayers(rendering.prepared->scene, layersNamed(options.layers), settings, context->info());
        rendering.still.phases.context = context_ms;
    }
    rendering.still.phases.load += load_ms;
    return rendering;
}

// The whole scene's, as cut to the device where one of the parts shows all of it; null for a plain shader.
const Plan* planOf(const Rendering& rendering)
{
    if (!rendering.prepared)
        return nullptr;
    const Plan& whole = rendering.prepared->plan;
    const auto& parts = rendering.still.parts;
    return !parts.empty() && parts.back().plan.seen == whole.seen ? &parts.back().plan : &whole;
}

// The fullest shader as `path`; those of lesser parts of the picture beside it, as "NAME-1.frag" and so on.
void writeShaders(const std::filesystem::path& path, const Still& still)
{
    for (std::size_t i = 0; i + 1 < still.parts.size(); ++i) {
        const auto name = fmt::format("{}-{}{}", path.stem().string(), i + 1, path.extension().string());
        const auto beside = path.parent_path() / name;
        writeFile(beside, shaderText(&still.parts[i], still.parts[i].shader));
        fmt::print(stderr, "{}: the shader where the picture shows {}\n", beside.string(),
                   still.parts[i].name);
    }
    writeFile(path, shaderText(still.parts.empty() ? nullptr : &still.parts.back(), still.shader));
}

} // namespace

ExitCode render(const RenderOptions& asked)
{
    Stopwatch whole;
    RenderOptions options = asked;
    const Input input = findInput(options.input);
    if (options.output.empty())
        options.output = input.name + ".png";
    refuseBadOptions(options, input);
    if (options.budget > 0)
        options.overrides.push_back(fmt::format("trace.budget={}", options.budget));
    if (input.plainShader)
        options.samples = 1; // it is asked once for each pixel
    if (!options.frames.empty())
        return renderFrames(options, input);
    // Folders that cannot be written to are refused before anything is drawn.
    PendingFile{options.output};
    if (!options.shader.empty())
        PendingFile{options.shader};
    Rendering rendering = renderInput(options, input);
    const Plan* plan = planOf(rendering);
    Stopwatch watch;
    std::optional<ShownView> shown;
    if (!options.view.empty())
        shown = shownView(rendering.still.picture, *rendering.prepared);
    const ViewLegend* legend = shown ? &shown->legend : nullptr;
    std::optional<Display> display; // none for a plain shader
    if (rendering.prepared)
        display = displayOf(options, rendering.prepared->scene.output);
    writeStill(options, {rendering.still, rendering.context, display ? &*display : nullptr,
                         shown ? &*shown : nullptr, rendering.layers});
    rendering.still.phases.write = watch.lap_ms();
    rendering.still.phases.total = whole.lap_ms();
    if (!options.shader.empty())
        writeShaders(options.shader, rendering.still);
    if (options.why)
        fmt::print("{}", whyText(plan, rendering.still));
    if (options.json)
        fmt::print("{}", jsonText(options, rendering.still, rendering.context, plan, legend));
    else if (legend != nullptr)
        fmt::print("{}\n", join(legend->lines, "\n"));
    if (rendering.still.nonfinite > 0)
        fmt::print(stderr, "dioptre: {} pixels are not finite\n", rendering.still.nonfinite);
    fmt::print(stderr, "{}: {}x{}, {} spp, {} ({})\n", options.output, options.width, options.height,
               options.samples, rendering.context.backend, rendering.context.renderer);
    return ExitCode::done;
}

} // namespace dioptre
