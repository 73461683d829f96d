// A line of a source as it is shown, and where a caret under it belongs.
#pragma once

#include <string>
#include <string_view>

namespace dioptre
{

// What columns count: drivers' messages are led back to bytes, the TOML library counts code points.
enum class ColumnUnit { bytes, codePoints };

struct ShownLine {
    std::string text; // with blanks for tabs
    int caret = -1;   // letters before it; -1: none
};

// `column` counts from 1; 0 where unknown. One beyond the line stands right behind it.
ShownLine shownLine(std::string_view line, int column, ColumnUnit unit);

} // namespace dioptre
