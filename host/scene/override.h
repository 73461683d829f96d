// The "path=value" of --set, written into a scene's document before it is read.
#pragma once

#include "scene/document.h"

#include <string>
#include <vector>

namespace dioptre
{

// Throws usage for an override without '=' and for a path that leads nowhere. What the value then says is
// checked with the rest of the scene, under the place "--set path=value".
void applyOverrides(Value& document, const std::vector<std::string>& overrides);

// "path=value,path=value" in its parts. A comma within brackets or quotes belongs to the value.
std::vector<std::string> splitOverrides(const std::string& text);

} // namespace dioptre
