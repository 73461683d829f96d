// How long the dotted keys of a TOML text are, seen before it is parsed.
#pragma once

#include "base/error.h"

#include <optional>
#include <string_view>

namespace dioptre
{

// Where a dotted key goes beyond that many parts, strings and comments left out; nothing where none does. The
// place has no path. Of a text that is no TOML any answer will do.
std::optional<SourcePosition> longKeyIn(std::string_view text, int mostParts);

} // namespace dioptre
