#include "base/statistics.h"
#include "command/bench_result.h"
#include "command/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace dioptre
{
namespace
{

// What is held to the first input; the frame first.
struct Quantity {
    const char* key;   // in JSON
    const char* title; // over its column
    std::vector<double> BenchRow::*values;
};
constexpr std::array quantities{Quantity{"frame", "frame ms", &BenchRow::frame_ms},
                                Quantity{"compile", "compile ms", &BenchRow::compile_ms},
                                Quantity{"first_draw", "first draw ms", &BenchRow::firstDraw_ms},
                                Quantity{"compile_through_first_draw", "both ms", &BenchRow::ready_ms},
                                Quantity{"peak", "peak MiB", &BenchRow::peak_mib}};

struct Comparison {
    Estimate ratio; // to the first input
    double spread = 0.0;
    bool differs = false;
};

Comparison compare(const BenchResult& result, const BenchRow& row, const Quantity& quantity)
{
    const auto& baseline = result.inputs.front().*quantity.values;
    Comparison comparison;
    comparison.spread = spreadOf(ratioOfMedians(result.control.*quantity.values, baseline));
    comparison.ratio = ratioOfMedians(row.*quantity.values, baseline);
    comparison.differs = differs(comparison.ratio, comparison.spread);
    return comparison;
}

// Four digits, as far as a figure has that many before its point.
std::string figure(double value)
{
    const int decimals = value >= 1000.0 ? 0 : value >= 100.0 ? 1 : value >= 10.0 ? 2 : 3;
    return fmt::format("{:.{}f}", value, decimals);
}

using Cells = std::vector<std::string>;

// The first column to the left, the others to the right, two blanks between them.
std::string aligned(const std::vector<Cells>& table)
{
    std::vector<std::size_t> widths(table.front().size());
    for (const Cells& cells : table)
        for (std::size_t i = 0; i < cells.size(); ++i)
            widths[i] = std::max(widths[i], cells[i].size());
    std::string text;
    for (const Cells& cells : table) {
        std::string line = fmt::format("{:<{}}", cells.front(), widths.front());
        for (std::size_t i = 1; i < cells.size(); ++i)
            line += fmt::format("  {:>{}}", cells[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

Cells frameCells(const BenchResult& result, const BenchRow& row)
{
    const Estimate frame = medianOf(row.frame_ms);
    const Comparison comparison = compare(result, row, quantities.front());
    const Estimate& ratio = comparison.ratio;
    Cells cells{row.name,
                figure(frame.value),
                fmt::format("{} to {}", figure(frame.low), figure(frame.high)),
                "1",
                "",
                "",
                row.raysPerPixel > 0.0 ? fmt::format("{:.2f}", row.raysPerPixel) : ""};
    if (&row == &result.inputs.front())
        return cells;
    cells[3] = fmt::format("{:.3f}", ratio.value);
    cells[4] = fmt::format("{:.3f} to {:.3f}", ratio.low, ratio.high);
    if (&row == &result.control)
        cells[5] = "control";
    else
        cells[5] = ratio.rounds < fewestRounds ? "too few rounds"
                   : !comparison.differs       ? "no difference"
                   : ratio.value > 1.0         ? "slower"
                                               : "faster";
    return cells;
}

std::string frameTable(const BenchResult& result)
{
    std::vector<Cells> table{
        {"frame", "median ms", "95 % interval", "ratio", "95 % interval", "", "rays a pixel"}};
    for (const BenchRow& row : result.inputs)
        table.push_back(frameCells(result, row));
    table.push_back(frameCells(result, result.control));
    if (result.plainTracer) {
        const PlainTracer& tracer = *result.plainTracer;
        table.push_back({"plain Python on " + tracer.scene, figure(tracer.frame_ms),
                         fmt::format("scaled from {} pixels", tracer.pixels),
                         figure(tracer.frame_ms / median(result.inputs.front().frame_ms)), "", "", ""});
    }
    return aligned(table);
}

// Ratios that are none are marked with =.
Cells coldCells(const BenchResult& result, const BenchRow& row)
{
    Cells cells{row.name};
    for (std::size_t i = 1; i < quantities.size(); ++i) {
        const Comparison comparison = compare(result, row, quantities[i]);
        cells.push_back(figure(median(row.*quantities[i].values)));
        if (&row == &result.inputs.front())
            cells.emplace_back("1 ");
        else
            cells.push_back(fmt::format("{:.2f}{}", comparison.ratio.value, comparison.differs ? ' ' : '='));
    }
    return cells;
}

std::string coldTable(const BenchResult& result)
{
    std::vector<Cells> table{{"cold start"}};
    for (std::size_t i = 1; i < quantities.size(); ++i) {
        table.front().emplace_back(quantities[i].title);
        table.front().emplace_back("ratio ");
    }
    for (const BenchRow& row : result.inputs)
        table.push_back(coldCells(result, row));
    table.push_back(coldCells(result, result.control));
    return aligned(table);
}

nlohmann::ordered_json toJson(const Estimate& estimate)
{
    return {{"median", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

nlohmann::ordered_json rowJson(const BenchResult& result, const BenchRow& row)
{
    nlohmann::ordered_json json = {{"name", row.name},
                                   {"frame_ms", toJson(medianOf(row.frame_ms))},
                                   {"compile_ms", median(row.compile_ms)},
                                   {"first_draw_ms", median(row.firstDraw_ms)},
                                   {"compile_through_first_draw_ms", median(row.ready_ms)},
                                   {"peak_mib", median(row.peak_mib)},
                                   {"rays_per_pixel", row.raysPerPixel},
                                   {"ratio", compare(result, row, quantities.front()).ratio.value}};
    for (const Quantity& quantity : quantities) {
        const Comparison comparison = compare(result, row, quantity);
        json["ratios"][quantity.key] = {{"value", comparison.ratio.value},
                                        {"low", comparison.ratio.low},
                                        {"high", comparison.ratio.high},
                                        {"differs", comparison.differs}};
    }
    json["rounds"] = {{"frame_ms", row.frame_ms},
                      {"compile_ms", row.compile_ms},
                      {"first_draw_ms", row.firstDraw_ms},
                      {"peak_mib", row.peak_mib}};
    return json;
}

} // namespace

std::string benchTables(const BenchResult& result)
{
    const BenchRow& first = result.inputs.front();
    const double spread = compare(result, result.control, quantities.front()).spread;
    std::string text =
        fmt::format("{}x{}, {} spp, {} ({}); clock: {}\n", result.width, result.height, result.samples,
                    result.context.backend, result.context.renderer, result.clock);
    text +=
        fmt::format("{} frames of each in turn, after {} to warm up; the first input twice: under {:.1f} % "
                    "is no difference\n\n",
                    first.frame_ms.size(), result.warmUpFrames, 100.0 * spread);
    text += frameTable(result);
    text += fmt::format(
        "\n{} cold starts of each in turn, without the driver's disk cache; = is no difference\n\n",
        first.compile_ms.size());
    return text + coldTable(result);
}

std::string benchJson(const BenchResult& result)
{
    const BenchRow& first = result.inputs.front();
    nlohmann::ordered_json json = {{"renderer", result.context.renderer},
                                   {"backend", result.context.backend},
                                   {"clock", result.clock},
                                   {"size", {result.width, result.height}},
                                   {"samples", result.samples},
                                   {"warm_up_frames", result.warmUpFrames},
                                   {"frames", first.frame_ms.size()},
                                   {"cold_starts", first.compile_ms.size()}};
    json["control"] = rowJson(result, result.control);
    for (const Quantity& quantity : quantities)
        json["control"]["spread"][quantity.key] = compare(result, result.control, quantity).spread;
    for (const BenchRow& row : result.inputs)
        json["inputs"].push_back(rowJson(result, row));
    if (const auto& tracer = result.plainTracer)
        json["python"] = {{"name", "plain Python on " + tracer->scene},
                          {"scaled_from_pixels", tracer->pixels},
                          {"drawn_ms", tracer->drawn_ms},
                          {"frame_ms", tracer->frame_ms},
                          {"ratio", tracer->frame_ms / median(first.frame_ms)}};
    return jsonText(json);
}

} // namespace dioptre
