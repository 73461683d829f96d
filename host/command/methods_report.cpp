// What `dioptre compare --methods` says.
#include "command/compare_methods.h"

#include "base/statistics.h"
#include "command/json_text.h"
#include "command/raster_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace dioptre
{

std::string methodsText(const CompareOptions& options, const MethodsResult& result)
{
    const MethodRow& first = result.rows.front();
    std::string text = fmt::format("{}: {}x{}, {} spp, {} ({}); errors from {}, frames in turn\n\n",
                                   result.scene, options.width, options.height, options.samples,
                                   result.context.backend, result.context.renderer, nameOf(first.method));
    text += fmt::format("{:<12}  {:>9}  {:>9}  {:>7}  {:>9}  {:>18}  {:>6}  {:>9}  {:>6}\n", "method", "RMSE",
                        "largest", "SSIM", "median ms", "95 % interval", "ratio", "triangles", "culled");
    for (const auto& row : result.rows) {
        const Estimate frame = medianOf(row.frame_ms);
        const auto& raster = row.facts.raster;
        text += fmt::format(
            "{:<12}  {:>9.5f}  {:>9.4f}  {:>7.4f}  {:>9.2f}  {:>18}  {:>6.3f}  {:>9}  {:>6}\n",
            nameOf(row.method), row.linear.rmse, row.linear.max, row.ssim, frame.value,
            fmt::format("{:.2f} to {:.2f}", frame.low, frame.high),
            ratioOfMedians(row.frame_ms, first.frame_ms).value,
            raster ? std::to_string(raster->triangles) : "",
            raster ? fmt::format("{} of {}", raster->culled, raster->culled + raster->drawn) : "");
    }
    for (const auto& row : result.rows)
        if (row.nonfinite > 0)
            text += fmt::format("{}: {} pixels are not finite, and left out of its errors\n",
                                nameOf(row.method), row.nonfinite);
    if (!options.output.empty())
        text += fmt::format("\n{}\n", options.output);
    return text;
}

std::string methodsJson(const CompareOptions& options, const MethodsResult& result)
{
    const MethodRow& first = result.rows.front();
    nlohmann::ordered_json json = {
        {"scene", options.reference},        {"size", {options.width, options.height}},
        {"samples", options.samples},        {"time_s", options.time_s},
        {"backend", result.context.backend}, {"renderer", result.context.renderer},
        {"held_to", nameOf(first.method)},   {"difference_scale", result.scale}};
    json["output"] =
        options.output.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(options.output);
    for (const auto& row : result.rows) {
        const Estimate frame = medianOf(row.frame_ms);
        const Estimate ratio = ratioOfMedians(row.frame_ms, first.frame_ms);
        nlohmann::ordered_json method = {
            {"method", nameOf(row.method)},
            {"frame_ms", {{"median", frame.value}, {"low", frame.low}, {"high", frame.high}}},
            {"ratio", {{"value", ratio.value}, {"low", ratio.low}, {"high", ratio.high}}},
            {"compile_ms", row.built.compile},
            {"first_draw_ms", row.built.firstDraw},
            {"rmse", row.linear.rmse},
            {"mae", row.linear.mae},
            {"relmse", row.linear.relmse},
            {"max", row.linear.max},
            {"ssim", row.ssim},
            {"nonfinite_pixels", row.nonfinite}};
        if (row.facts.raster)
            method["raster"] = rasterJson(*row.facts.raster);
        json["methods"].push_back(std::move(method));
    }
    return jsonText(json);
}

} // namespace dioptre
