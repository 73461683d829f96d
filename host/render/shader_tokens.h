// A shader's text as its words and signs.
#pragma once

#include "render/source_text.h"

#include <set>
#include <string_view>
#include <vector>

namespace dioptre
{

struct ShaderToken {
    std::string_view text; // a word, or one sign; into the source
    SourcePosition at;
    int conditionals = 0; // of #if, #else, #endif and their like that stand before it
    int depth = 0;        // of #if that it stands in
    std::size_t line = 0; // of the source, from 0
};

struct ShaderTokens {
    std::vector<ShaderToken> all; // outside comments and directives
    std::set<std::string_view> macros;
};

// `source` must outlive them.
ShaderTokens tokensOf(const SourceText& source);

// The place after the bracket, ( or {, that closes the one at `open`, or the end.
std::size_t afterBracket(const std::vector<ShaderToken>& all, std::size_t open);

} // namespace dioptre
