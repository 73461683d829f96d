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

std::string verdictText(const Verdict& verdict)
{
    return verdict.pass ? "pass" : "FAIL: " + verdict.reason;
}

std::string textbookText(const Verdict& verdict, bool control)
{
    if (!verdict.pass)
        return "fails";
    return control ? "passes (control)" : "passes";
}

std::string csvLine(const StabilityResult& result, const char* kernel, const CaseFigures& figures,
                    const Verdict& verdict)
{
    return fmt::format("{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{},\n", result.row->name,
                       kernel, figures.rays, figures.k, figures.relativeT, figures.relativeT_p999,
                       figures.normal_rad, figures.flips, figures.flipsOverMargin, figures.leaks,
                       figures.nonFinite, verdict.pass ? 1 : 0);
}

// Their own figures, in words.
std::string csvLine(const ValueRow& row, const char* kernel, const ValueFigures& figures,
                    const Verdict& verdict)
{
    return fmt::format("{},{},{},,,,,,,,{},{},\"{}\"\n", row.name, kernel, figures.rows, figures.nonFinite,
                       verdict.pass ? 1 : 0, figureText(row, figures));
}

std::string csvText(const StabilityTable& table)
{
    std::string text = "case,kernel,rays,k_max,t_rel_max,t_rel_p999,normal_rad_max,flips_per_million,"
                       "flips_over_margin_per_million,leaks_per_million,nonfinite,pass,figures\n";
    for (const auto& result : table.cases)
        text += csvLine(result, "ours", result.figures, result.verdict) +
                csvLine(result, "textbook", result.textbook, result.textbookVerdict);
    for (const auto& result : table.values)
        text += csvLine(*result.row, "ours", result.ours, result.verdict) +
                csvLine(*result.row, "textbook", result.textbook, result.textbookVerdict);
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

nlohmann::ordered_json figuresJson(const ValueRow& row, const ValueFigures& figures, const Verdict& verdict)
{
    nlohmann::ordered_json named = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.gates.size(); ++i)
        named[std::string(row.gates[i].what)] = number(figures.figures[i].value);
    return {{"figures", named}, {"nonfinite", figures.nonFinite}, {"pass", verdict.pass}};
}

// With the keys of the other rows, which have no figure here.
nlohmann::ordered_json resultJson(const ValueOutcome& result)
{
    const ValueRow& row = *result.row;
    nlohmann::ordered_json json = {{"case", row.name},
                                   {"about", row.about},
                                   {"rays", result.ours.rows},
                                   {"gate", gateText(row)},
                                   {"control", row.control}};
    for (const char* key : {"k_max", "t_rel_max", "flips_per_million", "normal_rad_max"})
        json[key] = nullptr;
    json.update(figuresJson(row, result.ours, result.verdict));
    json["reason"] = result.verdict.reason;
    json["textbook"] = figuresJson(row, result.textbook, result.textbookVerdict);
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
               verdictText(result.verdict), textbookText(result.textbookVerdict, result.row->control));
    std::fflush(stdout);
}

void printRow(const ValueOutcome& result, bool first)
{
    if (first)
        fmt::print("\n{:<22} {:>7}  {:<44} {:<44} {}\n", "case", "inputs", "figures", "textbook", "verdict");
    fmt::print("{:<22} {:>7}  {:<44} {:<44} {}; textbook {}\n", result.row->name, result.ours.rows,
               figureText(*result.row, result.ours), figureText(*result.row, result.textbook),
               verdictText(result.verdict), textbookText(result.textbookVerdict, result.row->control));
    std::fflush(stdout);
}

std::size_t StabilityTable::failures() const
{
    const auto fails = [](const auto& result) { return !result.verdict.pass; };
    return static_cast<std::size_t>(std::ranges::count_if(cases, fails) +
                                    std::ranges::count_if(values, fails));
}

void report(const StabilityOptions& options, const ContextInfo& device, const StabilityTable& table)
{
    if (!options.csv.empty())
        writeFile(options.csv, csvText(table));
    if (options.json) {
        nlohmann::ordered_json json = {{"renderer", device.renderer},
                                       {"backend", device.backend},
                                       {"seed", options.seed},
                                       {"cases", nlohmann::ordered_json::array()}};
        for (const auto& result : table.cases)
            json["cases"].push_back(resultJson(result));
        for (const auto& result : table.values)
            json["cases"].push_back(resultJson(result));
        fmt::print("{}", jsonText(json));
        return;
    }
    const std::size_t rows = table.cases.size() + table.values.size();
    fmt::print("\n{} of {} cases pass on {}\n", rows - table.failures(), rows, device.renderer);
    if (!table.cases.empty())
        fmt::print(
            "K: error of t across the surface, in units of float's rounding of the scene's size there; rays "
            "that\npass an edge within 8 such units count neither here nor behind the stroke of flips (hit "
            "for "
            "miss).\n");
}

} // namespace dioptre
