#include "command/frames_report.h"

#include "command/json_text.h"
#include "command/report.h"
#include "command/trust_account.h"
#include "command/video.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace dioptre
{
namespace
{

std::string nameOf(const RenderOptions& options, const FramesReport& report)
{
    return isVideo(options.output) ? options.output
                                   : FrameNames(options.output, report.frames.back().number).pattern();
}

nlohmann::ordered_json rowOf(const Frame& frame)
{
    nlohmann::ordered_json row = {{"frame", frame.number}, {"time_s", frame.time_s}};
    if (!frame.output.empty())
        row["output"] = frame.output;
    row["kept"] = frame.kept;
    if (frame.kept)
        return row;
    row["draw_ms"] = frame.figures.phases.draw;
    row["rays_per_pixel"] = frame.figures.raysPerPixel;
    row["nonfinite_pixels"] = frame.figures.nonfinite;
    if (frame.figures.beyondTrust)
        row["beyond_trust"] = *frame.figures.beyondTrust;
    return row;
}

// Of all frames together.
Phases sumOf(const FramesReport& report)
{
    Phases sum = report.made;
    sum.write += report.finish_ms;
    for (const auto& frame : report.frames)
        sum = together(sum, frame.figures.phases);
    return sum;
}

void printJson(const FramesReport& report, const RenderOptions& options, const FrameRange& range)
{
    const Phases sum = sumOf(report);
    nlohmann::ordered_json json = {
        {"output", nameOf(options, report)},
        {"size", {options.width, options.height}},
        {"samples", options.samples},
        {"fps", options.fps},
        {"first", range.first},
        {"last", range.last},
        {"step", range.step},
        {"drawn", report.drawn},
        {"kept", report.frames.size() - report.drawn},
        {"backend", report.context.backend},
        {"renderer", report.context.renderer},
        {"phases_ms",
         {{"context", sum.context},
          {"load", sum.load},
          {"compile", sum.compile},
          {"first_draw", sum.firstDraw},
          {"draw", sum.draw},
          {"read", sum.read},
          {"write", sum.write}}},
        {"total_ms", report.total_ms},
        {"frames", nlohmann::ordered_json::array()},
    };
    for (const auto& frame : report.frames)
        json["frames"].push_back(rowOf(frame));
    fmt::print("{}", jsonText(json));
}

} // namespace

void printReport(const FramesReport& report, const RenderOptions& options, const FrameRange& range)
{
    if (options.json)
        printJson(report, options, range);
    std::size_t nonfinite = 0;
    for (const auto& frame : report.frames)
        nonfinite += frame.figures.nonfinite;
    if (nonfinite > 0)
        fmt::print(stderr, "dioptre: {} pixels are not finite\n", nonfinite);
    const auto beyond = [](const Frame& frame) { return frame.figures.beyondTrust.value_or(0.0); };
    const auto worst = std::ranges::max_element(report.frames, {}, beyond);
    warnOfTrust(beyond(*worst), fmt::format("frame {}, the worst,", worst->number));
    const std::size_t kept = report.frames.size() - report.drawn;
    fmt::print(stderr, "{}: {} frames{}, {}x{}, {} spp, {} ({})\n", nameOf(options, report), report.drawn,
               kept > 0 ? fmt::format(" and {} kept", kept) : "", options.width, options.height,
               options.samples, report.context.backend, report.context.renderer);
}

} // namespace dioptre
