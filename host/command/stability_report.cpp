#include "command/stability_report.h"

#include "base/write_file.h"
#include "command/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace dioptre
{
namespace
{

std::string short_(double value)
{
    if (value == 0.0)
        return "0";
    return value >= 0.01 && value < 1000.0 ? fmt::format("{:.3g}", value) : fmt::format("{:.1e}", value);
}

std::string flipsText(const CaseFigures& figures)
{
    return fmt::format("{:.0f}/{:.0f}", figures.flips, figures.flipsOverMargin);
}

std::string verdictText(const StabilityResult& result)
{
    return result.verdict.pass ? "pass" : "FAIL: " + result.verdict.reason;
}

std::string textbookText(const StabilityResult& result)
{
    if (!result.textbookVerdict.pass)
        return "fails";
    return result.row->control ? "passes (control)" : "passes";
}

std::string csvLine(const StabilityResult& result, const char* kernel, const CaseFigures& figures,
                    const Verdict& verdict)
{
    return fmt::format("{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{}\n", result.row->name,
                       kernel, figures.rays, figures.k, figures.relativeT, figures.relativeT_p999,
                       figures.normal_rad, figures.flips, figures.flipsOverMargin, figures.leaks,
                       figures.nonFinite, verdict.pass ? 1 : 0);
}

std::string csvText(const std::vector<StabilityResult>& results)
{
    std::string text = "case,kernel,rays,k_max,t_rel_max,t_rel_p999,normal_rad_max,flips_per_million,"
                       "flips_over_margin_per_million,leaks_per_million,nonfinite,pass\n";
    for (const auto& result : results)
        text += csvLine(result, "ours", result.figures, result.verdict) +
                csvLine(result, "textbook", result.textbook, result.textbookVerdict);
    return text;
}

// JSON has no infinity.
nlohmann::ordered_json number(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json figuresJson(const CaseFigures& figures, const Verdict& verdict)
{
    return {{"k_max", number(figures.k)},
            {"t_rel_max", number(figures.relativeT)},
            {"t_rel_p999", number(figures.relativeT_p999)},
            {"flips_per_million", figures.flips},
            {"flips_over_margin_per_million", figures.flipsOverMargin},
            {"leaks_per_million", figures.leaks},
            {"normal_rad_max", number(figures.normal_rad)},
            {"nonfinite", figures.nonFinite},
            {"pass", verdict.pass}};
}

nlohmann::ordered_json resultJson(const StabilityResult& result)
{
    nlohmann::ordered_json json = {{"case", result.row->name},
                                   {"about", result.row->about},
                                   {"rays", result.figures.rays},
                                   {"gate", gateText(result.row->gate)},
                                   {"control", result.row->control}};
    json.update(figuresJson(result.figures, result.verdict));
    json["reason"] = result.verdict.reason;
    json["textbook"] = figuresJson(result.textbook, result.textbookVerdict);
    return json;
}

} // namespace

void printRow(const StabilityResult& result, bool first)
{
    if (first)
        fmt::print("{:<14} {:>7}  {:>8} {:>8} {:>9} {:>9}   {:>8} {:>8} {:>13}  {}\n{:<14} {:>7}  {:>8} "
                   "{:>8} {:>9} {:>9}\n",
                   "", "", "", "", "flips per", "", "textbook", "", "flips", "verdict", "case", "rays", "K",
                   "rel. t", "million", "normal");
    const auto& ours = result.figures;
    const auto& theirs = result.textbook;
    fmt::print("{:<14} {:>7}  {:>8} {:>8} {:>9} {:>9}   {:>8} {:>8} {:>13}  {}; textbook {}\n",
               result.row->name, ours.rays, short_(ours.k), short_(ours.relativeT), flipsText(ours),
               short_(ours.normal_rad), short_(theirs.k), short_(theirs.relativeT), flipsText(theirs),
               verdictText(result), textbookText(result));
    std::fflush(stdout);
}

void report(const StabilityOptions& options, const ContextInfo& device,
            const std::vector<StabilityResult>& results)
{
    const auto failed =
        std::ranges::count_if(results, [](const auto& result) { return !result.verdict.pass; });
    if (!options.csv.empty())
        writeFile(options.csv, csvText(results));
    if (options.json) {
        nlohmann::ordered_json json = {{"renderer", device.renderer},
                                       {"backend", device.backend},
                                       {"seed", options.seed},
                                       {"cases", nlohmann::ordered_json::array()}};
        for (const auto& result : results)
            json["cases"].push_back(resultJson(result));
        fmt::print("{}", jsonText(json));
        return;
    }
    fmt::print("\n{} of {} cases pass on {}\n"
               "K: error of t across the surface, in units of float's rounding of the scene's size there; "
               "rays that\n"
               "pass an edge within 8 such units count neither here nor behind the stroke of flips (hit for "
               "miss).\n",
               results.size() - static_cast<std::size_t>(failed), results.size(), device.renderer);
}

} // namespace dioptre
