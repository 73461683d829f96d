// The pictures that a scene's text names, for those who watch them.
#pragma once

#include "base/search_places.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

// Every file that may become one of the scene's pictures, those that are not there yet too: each name of each
// list, in each folder where it is looked for. `scene` is the file of the text. Of a text that is no TOML
// nothing is told; never throws.
std::vector<std::filesystem::path>
picturesNamedIn(const std::string& text, const std::filesystem::path& scene, const SearchPlaces& places);

} // namespace dioptre
