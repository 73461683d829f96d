#include "live/panel_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

bool isWhole(RowKind kind)
{
    return kind == RowKind::integer || kind == RowKind::toggle || kind == RowKind::choice;
}

bool startsWithSteps(std::string_view path, std::string_view start)
{
    return path.starts_with(start) && (path.size() == start.size() || path[start.size()] == '.');
}

// Six digits: a slider has no more, and a float's last ones are noise.
std::string numberText(const PanelRow& row, double number)
{
    return isWhole(row.kind) ? fmt::format("{:.0f}", number) : fmt::format("{:.6g}", number);
}

} // namespace

std::vector<double> fitted(const PanelRow& row, std::vector<double> numbers)
{
    for (double& number : numbers) {
        if (isWhole(row.kind))
            number = std::round(number);
        number = std::clamp(number, row.low, row.high);
    }
    const bool allZero = std::ranges::all_of(numbers, [](double number) { return number == 0.0; });
    return row.nonZero && allZero ? row.numbers : numbers;
}

std::string tomlOf(const PanelRow& row, const std::vector<double>& numbers)
{
    if (row.kind == RowKind::toggle)
        return numbers.front() != 0.0 ? "true" : "false";
    if (row.kind == RowKind::choice)
        return row.words.at(static_cast<std::size_t>(numbers.front())).value;
    if (numbers.size() == 1)
        return numberText(row, numbers.front());
    std::string list;
    for (const double number : numbers)
        list += (list.empty() ? "" : ", ") + numberText(row, number);
    return "[" + list + "]";
}

bool overlap(std::string_view a, std::string_view b)
{
    return startsWithSteps(a, b) || startsWithSteps(b, a);
}

} // namespace dioptre
