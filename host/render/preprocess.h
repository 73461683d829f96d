// #include, and the conditionals that the plan decides, resolved by the host: what is out is not in the text.
#pragma once

#include "base/search_places.h"
#include "render/source_text.h"

#include <map>
#include <set>
#include <string>

namespace dioptre
{

struct PreprocessInput {
    Search search;                               // where #include names lead
    std::map<std::string, SourceText> generated; // includes that the assembler wrote itself, by name
    std::set<std::string> features; // HAS_ names that are there, beside those that the text defines
};

// Resolves every #include, and every #ifdef, #ifndef, #else, #endif on a name that begins with HAS_. Each
// file is taken once; other directives are left for the driver. Throws badInput (cycles, unbalanced
// conditionals, names that lead elsewhere), inputMissing.
SourceText preprocess(const SourceText& source, const PreprocessInput& input);

} // namespace dioptre
