#include "base/clock.h"
#include "base/file.h"
#include "base/interruption.h"
#include "base/text.h"
#include "base/write_file.h"
#include "command/command.h"
#include "command/draw_picture.h"
#include "command/frames.h"
#include "command/progress.h"
#include "command/render_steps.h"
#include "command/report.h"
#include "command/settings_hash.h"
#include "command/trust_account.h"
#include "raster/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace dioptre
{

void refuseBadOptions(const RenderOptions& options, const Input& input)
{
    if (!(std::abs(options.time_s) <= static_cast<double>(std::numeric_limits<float>::max())))
        fail(ExitCode::usage, fmt::format("--time {} is no moment", options.time_s),
             "give a number of seconds that a 32-bit float can hold");
    if (!(options.drawLimit_s > 0.0 && std::isfinite(options.drawLimit_s)))
        fail(ExitCode::usage, fmt::format("--draw-limit {} is no time", options.drawLimit_s),
             "give a number of seconds above 0");
    if (!options.tile.empty() && !options.frames.empty())
        fail(ExitCode::usage, "--tile parts one picture, and --frames asks for several",
             "leave one of them out: machines can share the frames");
    refuseBadOutput(options, input.plainShader);
    if (input.plainShader && (options.reference || options.budget > 0 || !options.view.empty()))
        fail(ExitCode::usage,
             options.input + " is a plain shader, and --budget, --view and --reference are for scenes",
             "leave them out");
    const bool rasterised = isRasterised(methodNamed(options.method));
    if (rasterised && input.plainShader)
        fail(ExitCode::usage, options.input + " is a plain shader, and --method is for scenes",
             "leave it out");
    if (rasterised && (options.reference || !options.view.empty() || !options.layers.empty()))
        fail(ExitCode::usage,
             "--view, --layers and --reference are of traced pictures, and --method " + options.method +
                 " rasterises",
             "leave one of them out");
    if (rasterised && options.budget > 0)
        fail(ExitCode::usage, "--budget counts rays, and --method " + options.method + " traces none",
             "leave one of them out");
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

// The whole scene's, as cut to the device where one of the parts shows all of it; null for a plain shader.
const Plan* planOf(const PictureDrawer& drawer, const DrawingFacts& facts)
{
    if (drawer.prepared() == nullptr)
        return nullptr;
    const Plan& whole = drawer.prepared()->plan;
    return !facts.parts.empty() && facts.parts.back().plan.seen == whole.seen ? &facts.parts.back().plan
                                                                              : &whole;
}

// The fullest shader as `path`; beside it those of lesser parts of the picture, as "NAME-1.frag" and so on,
// and of what is rasterised the vertices', as "NAME.vert".
void writeShaders(const std::filesystem::path& path, const DrawingFacts& facts)
{
    for (std::size_t i = 0; i + 1 < facts.parts.size(); ++i) {
        const auto name = fmt::format("{}-{}{}", path.stem().string(), i + 1, path.extension().string());
        const auto beside = path.parent_path() / name;
        writeFile(beside, shaderText(&facts.parts[i], facts.parts[i].shader));
        fmt::print(stderr, "{}: the shader where the picture shows {}\n", beside.string(),
                   facts.parts[i].name);
    }
    if (!facts.vertexShader.empty()) {
        const auto beside = std::filesystem::path(path).replace_extension(".vert");
        writeFile(beside, flatten(facts.vertexShader));
        fmt::print(stderr, "{}: the vertices' shader\n", beside.string());
    }
    writeFile(path, shaderText(facts.parts.empty() ? nullptr : &facts.parts.back(), facts.shader));
}

// "still_life.png", or "still_life-2-of-8.png" for a tile.
std::string defaultOutput(const RenderOptions& options, const Input& input)
{
    std::string tile = options.tile;
    if (const auto slash = tile.find('/'); slash != std::string::npos)
        tile.replace(slash, 1, "-of-");
    return input.name + (tile.empty() ? "" : "-" + tile) + ".png";
}

// What a picture that is there may not be.
void warn(const Plan* plan, const StillReport& still)
{
    if (still.figures.counts.nonfinite > 0)
        fmt::print(stderr, "dioptre: {} pixels are not finite\n", still.figures.counts.nonfinite);
    if (plan != nullptr && plan->choosesKernels() && plan->guard == Guard::none)
        fmt::print(stderr,
                   "dioptre: this driver's sums are not exact, and kernels that were chosen for precision "
                   "rely on them: --why names the objects, --reference draws in double precision\n");
    warnOfTrust(still.beyondTrust.value_or(0.0), "the picture");
}

// What is said of a picture that is there.
void report(const RenderOptions& options, const PictureDrawer& drawer, const StillReport& still)
{
    const Plan* plan = planOf(drawer, still.facts);
    if (options.why)
        fmt::print("{}", whyText(plan, still));
    const ViewLegend* legend = still.figures.legend ? &*still.figures.legend : nullptr;
    if (options.json)
        fmt::print("{}", jsonText(options, still, drawer.context(), plan));
    else if (legend != nullptr)
        fmt::print("{}\n", join(legend->lines, "\n"));
    warn(plan, still);
    fmt::print(stderr, "{}: {}{}x{}, {} spp, {} ({})\n", options.output,
               options.tile.empty() ? "" : "tile " + options.tile + " of ", options.width, options.height,
               options.samples, drawer.context().backend, drawer.context().renderer);
}

void renderStill(RenderOptions options, const Input& input)
{
    Stopwatch whole;
    const int atOnce = rowsAtOnce(options);
    // Folders that cannot be written to are refused before anything is drawn.
    PendingFile{options.output};
    if (!options.shader.empty())
        PendingFile{options.shader};
    PictureDrawer drawer(options, input, options.time_s, atOnce);
    if (!options.tile.empty())
        options.settingsHash = settingsHash(options, drawer.context(), drawer.sourcesFingerprint());
    StillReport still;
    still.beyondTrust = TrustAccount(options)(drawer); // first: a signal finds nothing written yet
    still.figures = drawPicture(drawer, options, nullptr, terminalProgress());
    still.facts = drawer.facts();
    still.phases = together(drawer.made(), still.figures.phases);
    if (!options.shader.empty())
        writeShaders(options.shader, still.facts);
    still.phases.total = whole.lap_ms();
    report(options, drawer, still);
}

} // namespace

ExitCode render(const RenderOptions& asked)
{
    RenderOptions options = asked;
    const Input input = findInput(options.input);
    if (options.output.empty())
        options.output = defaultOutput(options, input);
    refuseBadOptions(options, input);
    if (options.budget > 0)
        options.overrides.push_back(fmt::format("trace.budget={}", options.budget));
    if (input.plainShader)
        options.samples = 1; // it is asked once for each pixel
    if (!options.frames.empty())
        return renderFrames(options, input);
    if (const int signal = signalDuring([&] { renderStill(options, input); }); signal != 0) {
        fmt::print(stderr, "dioptre: stopped by a signal, and nothing was written\n");
        endBySignal(signal);
    }
    return ExitCode::done;
}

} // namespace dioptre
