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

} // namespace dioptre
