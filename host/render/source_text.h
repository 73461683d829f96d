// Shader text that remembers where each line comes from, so that a driver's messages can be led back to the
// author's file.
#pragma once

#include "base/error.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

struct SourceLine {
    std::string text;
    std::string file; // as named to the user; "generated" for what the assembler wrote
    int line = 0;     // in that file, counted from 1
};

using SourceText = std::vector<SourceLine>;

// Cuts a text into lines of `file`; ends of line of any system, a byte-order mark is dropped.
SourceText linesOf(std::string_view text, const std::string& file);

// The lines of a file. Throws inputMissing, and badInput at a byte of 0: drivers would end the shader there.
SourceText readSource(const std::filesystem::path& path);

// The lines as one string for the driver.
std::string flatten(const SourceText& source);

// The same without comments: texts that differ in comments alone are the same to a compiler.
std::string flattenWithoutComments(const SourceText& source);

// Identifiers of a line, comments left out; `inComment` carries an open /* from line to line.
std::vector<std::string_view> identifiers(std::string_view line, bool& inComment);

} // namespace dioptre
