// Leaves out what a shader never uses: functions, structs, constants, macros and uniforms that main() cannot
// reach.
#pragma once

#include "render/source_text.h"

#include <set>
#include <string>

namespace dioptre
{

// A declaration at file scope, with the comment above it.
struct ShaderItem {
    enum class Kind { heading, function, structure, macro, uniform, block, constant, output, other };
    Kind kind = Kind::other;
    std::set<std::string> names;      // what it declares; a block declares its members too
    std::set<std::string> references; // identifiers that it mentions
    std::size_t first = 0;            // lines of the source, [first, last)
    std::size_t last = 0;
};

// The declarations of a whole shader, in order. A comment that stands alone (blank line after it) is a
// heading.
std::vector<ShaderItem> itemsOf(const SourceText& source);

// The shader with nothing but what main() reaches, its outputs, directives, and the headings of files that
// still hold something.
SourceText prune(const SourceText& source);

} // namespace dioptre
