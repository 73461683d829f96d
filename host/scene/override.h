// The "path=value" of --set, written into a scene's document before it is read.
#pragma once

#include "scene/document_path.h"

#include <string>
#include <vector>

namespace dioptre
{

// What an override changed.
struct Overridden {
    SourcePosition place; // "--set path=value"
    Steps steps;
};

// Throws usage for an override without '=' and for a path that leads nowhere. What the value then says is
// checked with the rest of the scene, under the place "--set path=value".
std::vector<Overridden> applyOverrides(Value& document, const std::vector<std::string>& overrides);

// "path=value,path=value" in its parts. A comma within brackets or quotes belongs to the value.
std::vector<std::string> splitOverrides(const std::string& text);

} // namespace dioptre
