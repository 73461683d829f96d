// Where in an author's line a driver's message points.
#pragma once

#include "gl/program.h"
#include "render/source_text.h"

namespace dioptre
{

// The column, in bytes from 1, of a message that speaks of `source[index]`; 0 where it has none or macros
// before it leave it in the dark.
int authorColumn(const LogMessage& message, const SourceText& source, std::size_t index);

} // namespace dioptre
