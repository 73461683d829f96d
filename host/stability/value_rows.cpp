#include "stability/value_rows.h"

#include "base/error.h"
#include "stability/random_floats.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

std::vector<ValueRow> gathered()
{
    std::vector<ValueRow> rows;
    for (const auto& topic : {refractionValues(), shadingValues(), pathValues(), orbitValues()})
        rows.insert(rows.end(), topic.begin(), topic.end());
    return rows;
}

} // namespace

ValueRow asControl(ValueRow row)
{
    row.control = true;
    return row;
}

std::span<const ValueRow> valueRows()
{
    static const std::vector<ValueRow> rows = gathered();
    return rows;
}

const ValueRow& valueRow(std::string_view name)
{
    const auto rows = valueRows();
    const auto found = std::ranges::find(rows, name, &ValueRow::name);
    if (found != rows.end())
        return *found;
    std::string names;
    for (const ValueRow& row : rows)
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    fail(ExitCode::usage, fmt::format("no stability case is called \"{}\"", name), "it is one of " + names);
}

std::vector<glm::dvec4> inputsOf(const ValueRow& row, std::uint64_t seed, std::size_t count)
{
    RandomFloats random(seedOf(row.name, seed));
    std::vector<glm::dvec4> texels;
    texels.reserve(count * row.texels);
    for (std::size_t i = 0; i < count; ++i)
        row.append(random, texels);
    return texels;
}

std::string gateText(const ValueRow& row)
{
    std::string text;
    for (const ValueGate& gate : row.gates)
        text += fmt::format("{}{} <= {:g}", text.empty() ? "" : ", ", gate.what, gate.most);
    return text;
}

} // namespace dioptre
