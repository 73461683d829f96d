// What feeds a picture: the files whose change can change it.
#pragma once

#include "base/search_places.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

// Each file once, those that are not there (yet) too: a name stands for a file in each folder where it is
// looked for. Faulty TOML, missing and circular includes and files that cannot be read give what can be told:
// neither throws. Which features a scene has is not looked at: all includes count.

// The scene's file, its pictures, and what ray_trace.frag can reach. `text` is the file's; pictures that
// --set names are not in it.
std::vector<std::filesystem::path> filesOfScene(const std::filesystem::path& scene, const std::string& text,
                                                const SearchPlaces& places);

// Files of the program's own and what they can reach; `names`: as an #include has them.
std::vector<std::filesystem::path> filesOfSources(const std::vector<std::string>& names,
                                                  const SearchPlaces& places);

// The shader's file and what it can reach; its channels' pictures are the caller's.
std::vector<std::filesystem::path> filesOfShader(const std::filesystem::path& shader,
                                                 const SearchPlaces& places);

} // namespace dioptre
