#include "live/panel_output_rows.h"

#include "live/panel_words.h"
#include "scene/choices.h"

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr double usualGamma = 2.2;

bool isExposure(const PanelRow& row)
{
    return row.path == "output.exposure";
}

bool isCurve(const PanelRow& row)
{
    return row.path == "output.curve";
}

bool isGamma(const PanelRow& row)
{
    return row.path == "output.gamma";
}

} // namespace

std::vector<PanelRow> outputRows(const Display& display)
{
    std::vector<PanelRow> rows;
    rows.push_back({"Output",
                    "",
                    "output.exposure",
                    "exposure, stops",
                    RowKind::number,
                    {display.exposure},
                    std::min(-10.0, display.exposure),
                    std::max(10.0, display.exposure)});
    rows.push_back({"Output",
                    "",
                    "output.curve",
                    "curve",
                    RowKind::choice,
                    {placeIn(toneCurves, display.curve)},
                    0.0,
                    static_cast<double>(toneCurves.size() - 1)});
    rows.back().words = wordsOf(toneCurves);
    rows.push_back({"Output", "", "output.gamma", "transfer", RowKind::choice, {display.gamma ? 1.0 : 0.0}});
    rows.back().words = {{"\"srgb\"", "sRGB"},
                         {fmt::format("{}", display.gamma.value_or(usualGamma)), "a power"}};
    if (display.gamma)
        rows.push_back(
            {"Output", "", "output.gamma", "gamma", RowKind::number, {*display.gamma}, 0.1, 10.0, true});
    return rows;
}

Display withOutput(Display display, const PanelRow& row, const std::vector<double>& numbers)
{
    if (isExposure(row))
        display.exposure = numbers.front();
    else if (isCurve(row))
        display.curve = toneCurves.at(static_cast<std::size_t>(numbers.front())).choice;
    else if (row.kind == RowKind::number)
        display.gamma = numbers.front();
    else if (numbers.front() == 0.0)
        display.gamma.reset();
    else
        display.gamma = display.gamma.value_or(usualGamma);
    return display;
}

Display withOutputOf(const Display& other, const PanelRow& row, Display display)
{
    if (isExposure(row))
        display.exposure = other.exposure;
    else if (isCurve(row))
        display.curve = other.curve;
    else
        display.gamma = other.gamma;
    return display;
}

bool differs(const Display& a, const Display& b, const PanelRow& row)
{
    return isExposure(row) ? a.exposure != b.exposure
           : isCurve(row)  ? a.curve != b.curve
                           : a.gamma != b.gamma;
}

std::vector<std::string> overridesOf(const Display& display, const Display& other)
{
    std::vector<std::string> overrides;
    for (const PanelRow& row : outputRows(display)) {
        const bool isSaidElsewhere =
            isGamma(row) && (row.kind == RowKind::number) != display.gamma.has_value();
        if (differs(display, other, row) && !isSaidElsewhere)
            overrides.push_back(row.path + "=" + tomlOf(row, row.numbers));
    }
    return overrides;
}

} // namespace dioptre
