#include "command/bench_input.h"
#include "command/bench_result.h"
#include "command/cold_start.h"
#include "command/command.h"
#include "command/input.h"
#include "command/plain_tracer.h"
#include "command/progress.h"
#include "render/interleave.h"
#include "render/plain.h"
#include "render/still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace dioptre
{
namespace
{

constexpr double budgetAnInput_ms = 20000.0;

Rounds roundsOf(const BenchOptions& options, std::size_t inputs)
{
    Rounds rounds;
    if (options.frames > 0)
        rounds.most = static_cast<std::size_t>(options.frames);
    else
        rounds.budget_ms = budgetAnInput_ms * static_cast<double>(inputs);
    return rounds;
}

// Of the frame that was drawn last, 0 for a plain shader, of which nobody knows; it is checked on the way.
double raysPerPixel(const MethodDrawing& drawn, const std::string& name)
{
    Picture picture = drawn.drawing->read();
    const auto pixels = static_cast<double>(picture.floats.size()) / 4.0;
    const PixelCounts counts = drawn.drawing->finish(picture);
    if (counts.nonfinite > 0)
        fmt::print(stderr, "dioptre: {}: {} pixels are not finite\n", name, counts.nonfinite);
    return counts.rays / pixels;
}

// All inputs in one context; rows and inputs correspond.
void timeFrames(const std::vector<BenchInput>& inputs, const BenchOptions& options, BenchResult& result,
                std::vector<BenchRow>& rows)
{
    const ViewSettings view{options.width, options.height, options.samples.value_or(1), glslFolder()};
    if (std::ranges::any_of(inputs, &BenchInput::plainShader))
        startVariablesAtZero();
    const auto context = makeContext(options.backend);
    const ClockKind kind = clockFor(context->info());
    const Rounds rounds = roundsOf(options, inputs.size());
    std::vector<MethodDrawing> made;
    std::vector<Drawing*> drawings;
    for (const auto& input : inputs) {
        made.push_back(drawingOf(input, view, context->info()));
        drawings.push_back(made.back().drawing.get());
    }
    FrameClock clock(kind);
    const auto times_ms = timeInterleaved(drawings, clock, rounds, terminalProgress());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].frame_ms = times_ms[i];
        rows[i].raysPerPixel = raysPerPixel(made[i], rows[i].name);
    }
    result.context = context->info();
    result.clock = nameOf(kind);
    result.warmUpFrames = rounds.warmUp;
}

void refuseBadOptions(const BenchOptions& options, const std::vector<BenchInput>& inputs)
{
    if (options.samples && std::ranges::all_of(inputs, &BenchInput::plainShader))
        fail(ExitCode::usage,
             fmt::format("--spp {} is for scenes, and {} is a plain shader, asked once for each pixel",
                         *options.samples, inputs.front().name),
             "leave it out, or name a scene too");
    for (const auto& input : inputs)
        if (!input.plainShader)
            sceneOf(input); // its faults are told before anything is measured
    if (options.python && isRasterised(inputs.front().method))
        fail(ExitCode::usage, inputs.front().name + " is rasterised, and --python traces scenes",
             "put a traced scene first, or leave --python out");
    if (options.python && inputs.front().plainShader)
        fail(ExitCode::usage, inputs.front().name + " is a plain shader, and --python traces scenes",
             "put a scene first, or leave --python out");
}

} // namespace

ExitCode bench(const BenchOptions& options)
{
    std::vector<BenchInput> inputs;
    for (const auto& text : options.inputs)
        inputs.push_back(readBenchInput(text, searchPlaces(options.included), options.method));
    if (options.coldStart)
        return startCold(inputs.front(), options);
    refuseBadOptions(options, inputs);

    BenchResult result;
    result.width = options.width;
    result.height = options.height;
    result.samples = options.samples.value_or(1);
    if (options.python)
        result.plainTracer = runPlainTracer(inputs.front(), options);
    inputs.push_back(inputs.front()); // the control
    std::vector<BenchRow> rows(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i)
        rows[i].name = inputs[i].name;
    rows.back().name += ", again";
    measureColdStarts(inputs, options, rows, terminalProgress());
    timeFrames(inputs, options, result, rows);

    result.control = std::move(rows.back());
    rows.pop_back();
    result.inputs = std::move(rows);
    fmt::print("{}", options.json ? benchJson(result) : benchTables(result));
    return ExitCode::done;
}

} // namespace dioptre
