#include "live/panel_method_rows.h"

#include <algorithm>
#include <cstdlib>

namespace dioptre
{
namespace
{

constexpr const char* methodGroup = "Method";

// Powers of two, and what the words of the command line asked for.
std::vector<int> facetCounts(int now)
{
    std::vector<int> counts{now};
    for (int count = leastFacets; count <= mostFacets; count *= 2)
        if (count != now)
            counts.push_back(count);
    std::ranges::sort(counts);
    return counts;
}

template <typename Numbers>
PanelRow numberChoice(const char* path, const char* label, const Numbers& choices, int now)
{
    PanelRow row{methodGroup, "", path, label, RowKind::choice};
    double place = 0.0;
    for (const int choice : choices) {
        if (choice == now)
            place = static_cast<double>(row.words.size());
        row.words.push_back({std::to_string(choice), std::to_string(choice)});
    }
    row.numbers = {place};
    row.high = static_cast<double>(row.words.size() - 1);
    return row;
}

// Of a table with names.
template <typename Table, typename IsNow>
PanelRow namedChoice(const char* path, const char* label, const Table& table, const IsNow& isNow)
{
    PanelRow row{methodGroup, "", path, label, RowKind::choice};
    const auto now = std::ranges::find_if(table, isNow);
    row.numbers = {static_cast<double>(now - table.begin())};
    row.high = static_cast<double>(table.size() - 1);
    for (const auto& each : table) {
        row.words.push_back({std::string(each.name), std::string(each.name)});
        row.meaning += (row.meaning.empty() ? "" : "\n") + row.words.back().label + ": ";
        row.meaning += each.meaning;
    }
    return row;
}

void addMethod(std::vector<PanelRow>& rows, const Method& method, const char* path, const char* facetsPath,
               const char* label)
{
    rows.push_back(namedChoice(path, label, shadings,
                               [&](const ShadingRow& row) { return row.shading == method.shading; }));
    if (!isRasterised(method))
        return;
    rows.push_back(numberChoice(facetsPath, "facets a side", facetCounts(method.facets), method.facets));
    rows.back().meaning = "N x N facets a shape";
}

Method withShading(const Method& method, Shading shading)
{
    if (shading == Shading::trace)
        return {};
    return {shading, isRasterised(method) ? method.facets : usualFacets};
}

} // namespace

std::vector<PanelRow> methodRows(const MethodChoice& choice)
{
    std::vector<PanelRow> rows;
    addMethod(rows, choice.method, "method", "method.facets", "method");
    rows.push_back(namedChoice("compare", "compare", comparisons, [&](const ComparisonRow& row) {
        return row.comparison == choice.comparison;
    }));
    if (choice.comparison != Comparison::off)
        addMethod(rows, choice.other, "other", "other.facets", "with");
    if (choice.comparison == Comparison::difference)
        rows.push_back(numberChoice("scale", "times", differenceScales, choice.scale));
    if (drawsFacets(choice)) {
        rows.push_back({methodGroup, "", "edges", "edges", RowKind::toggle, {choice.wires ? 1.0 : 0.0}});
        rows.back().meaning = "of the facets, over the picture";
    }
    return rows;
}

MethodChoice withMethod(MethodChoice choice, const PanelRow& row, const std::vector<double>& numbers)
{
    const auto place = static_cast<std::size_t>(numbers.front());
    const auto number = [&] { return std::atoi(row.words.at(place).value.c_str()); };
    if (row.path == "method")
        choice.method = withShading(choice.method, shadings.at(place).shading);
    else if (row.path == "method.facets")
        choice.method.facets = number();
    else if (row.path == "compare")
        choice.comparison = comparisons.at(place).comparison;
    else if (row.path == "other")
        choice.other = withShading(choice.other, shadings.at(place).shading);
    else if (row.path == "other.facets")
        choice.other.facets = number();
    else if (row.path == "scale")
        choice.scale = number();
    else
        choice.wires = place != 0;
    return choice;
}

} // namespace dioptre
