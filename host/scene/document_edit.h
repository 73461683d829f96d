// Values written into a scene's text where they stand, the rest of it kept byte for byte.
#pragma once

#include <string>
#include <vector>

namespace dioptre
{

// The text with the "path=value" of --set written into it, in order. Of a value that is there only its
// characters change, of a list of the same length only those of the elements that differ; comments, layout,
// ends of line and a byte-order mark stay. A key that is not there becomes a line behind the last one of its
// table, or a part of its inline table; a section that the file lacks is appended. A new kind of sky takes
// the place of the old, whose keys go.
//
// What is given back is proven: it reads as `text` does under applyOverrides(). `path` is for messages.
// Throws badInput for a text that is no TOML and where a value would take the place of tables with headers of
// their own, and usage as applyOverrides() does.
std::string withValues(const std::string& text, const std::string& path,
                       const std::vector<std::string>& overrides);

} // namespace dioptre
