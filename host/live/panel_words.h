// Words of the scene's choices as those of a row.
#pragma once

#include "live/panel_row.h"

#include <fmt/format.h>

namespace dioptre
{

// `table`: of NamedChoice.
template <class Table>
std::vector<RowWord> wordsOf(const Table& table)
{
    std::vector<RowWord> words;
    for (const auto& row : table)
        words.push_back({fmt::format("\"{}\"", row.name), std::string(row.name)});
    return words;
}

template <class Table, class Choice>
double placeIn(const Table& table, Choice choice)
{
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].choice == choice)
            return static_cast<double>(i);
    return 0.0;
}

} // namespace dioptre
