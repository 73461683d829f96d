// Compiling assembled text, with the driver's messages led back to the author's files.
#pragma once

#include "gl/program.h"
#include "render/source_text.h"

namespace dioptre
{

// Throws badInput: each message as "file:line:column: message", the source line below it, and as a
// complaint.
Program buildProgram(const SourceText& fragment, const SourceText& vertex);
Program buildProgram(const SourceText& fragment);

// The same for what another process heard of its driver.
[[noreturn]] void failToBuild(const ShaderError& error, const SourceText& fragment, const SourceText& vertex);

} // namespace dioptre
