// Values as TOML text, and whether two values say the same.
#pragma once

#include "scene/document.h"

#include <string>
#include <string_view>

namespace dioptre
{

// A key as it stands before an equals sign: bare where TOML allows that, else in quotes.
std::string keyText(std::string_view key);

// A value in TOML: numbers as short as reads back the same, "1.0" for a float of one. Where `old`, the value
// whose place it takes, has floats, whole numbers are written as floats too. Throws badInput for a date or a
// table, which no override holds.
std::string valueText(const Value& value, const Value* old = nullptr);

// Whether both say the same: places aside, tables in any order, and 1 as good as 1.0, as in all scenes.
bool saySame(const Value& a, const Value& b);

} // namespace dioptre
