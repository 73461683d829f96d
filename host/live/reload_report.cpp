#include "base/statistics.h"
#include "command/json_text.h"
#include "live/reload_bench.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace dioptre
{
namespace
{

struct Spread {
    double p50 = 0.0, p95 = 0.0, most = 0.0;
};

Spread spreadOf(const std::vector<double>& values)
{
    if (values.empty())
        return {};
    return {quantile(values, 0.5), quantile(values, 0.95), *std::ranges::max_element(values)};
}

std::string cells(const std::vector<double>& values, int decimals)
{
    if (values.empty())
        return fmt::format("{:>8}{:>8}{:>8}", "-", "-", "-");
    const auto [p50, p95, most] = spreadOf(values);
    return fmt::format("{:8.{}f}{:8.{}f}{:8.{}f}", p50, decimals, p95, decimals, most, decimals);
}

nlohmann::ordered_json json(const std::vector<double>& values)
{
    if (values.empty())
        return nullptr;
    const auto [p50, p95, most] = spreadOf(values);
    return {{"p50", p50}, {"p95", p95}, {"max", most}};
}

} // namespace

std::string reloadText(const ReloadResult& result, const ReloadBenchOptions& options)
{
    std::string text = fmt::format("{} ({}x{}), {} edits of each kind, {}\n"
                                   "a frame takes {:.1f} ms while the picture runs; compile through first "
                                   "draw, as bench has it, {:.0f} ms\n\n"
                                   "{:26}{:>24}{:>24}{:>24}\n{:26}",
                                   options.input, options.width, options.height, options.edits,
                                   result.renderer, result.frame_ms, result.cold_ms, "",
                                   "save to picture, ms", "of it compiler, ms", "longest gap, frames", "");
    for (int i = 0; i < 3; ++i)
        text += fmt::format("{:>8}{:>8}{:>8}", "p50", "p95", "max");
    text += "\n";
    for (const auto& row : result.rows)
        text += fmt::format("{:26}{}{}{}\n", row.name, cells(row.shown_ms, 1), cells(row.compile_ms, 1),
                            cells(row.gap, 2));
    return text;
}

std::string reloadJson(const ReloadResult& result, const ReloadBenchOptions& options)
{
    nlohmann::ordered_json all = {{"input", options.input},
                                  {"size", {options.width, options.height}},
                                  {"edits", options.edits},
                                  {"renderer", result.renderer},
                                  {"frame_ms", result.frame_ms},
                                  {"cold_ms", result.cold_ms},
                                  {"kinds", nlohmann::ordered_json::array()}};
    for (const auto& row : result.rows)
        all["kinds"].push_back({{"kind", row.name},
                                {"shown_ms", json(row.shown_ms)},
                                {"frames", json(row.frames)},
                                {"compile_ms", json(row.compile_ms)},
                                {"gap_frames", json(row.gap)}});
    return jsonText(all);
}

} // namespace dioptre
