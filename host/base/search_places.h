// Where the files lie that scenes and shaders name, and which of them they may reach: what comes from
// strangers must not read what it likes.
#pragma once

#include "base/error.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

// The folders that a scene or a shader may take files from besides its own.
struct SearchPlaces {
    std::vector<std::filesystem::path> included; // named by the user, --include, in turn
    std::filesystem::path glslFolder;            // the program's glsl/, beside its textures/; "" for neither
};

// Beside `glslFolder`, which must be named.
std::filesystem::path texturesFolder(const SearchPlaces& places);

// What the names in one file may stand for.
struct Search {
    std::vector<std::filesystem::path> folders;      // that names are looked for in, in turn
    std::vector<std::filesystem::path> mayAlsoReach; // by ".." and the like, beside those
    std::string_view owner = "shader";               // or "scene", for messages
};

// The program's data may be reached besides. Names are looked for beside `file`, in the folders of --include
// and in `data`, in turn.
Search searchFrom(const std::filesystem::path& file, const SearchPlaces& places,
                  const std::vector<std::filesystem::path>& data, std::string_view owner);

// Every file that a name may stand for, the first that exists before the others; each once.
std::vector<std::filesystem::path> candidatesOf(const std::string& name, const Search& search);

// The first candidate that is a file; "" where none is. Throws badInput at `where` if that one, links
// followed, does not lie in the search's folders or below them, or if none of the candidates would.
std::filesystem::path lookFor(const std::string& name, const Search& search, const SourcePosition& where);

// The first candidate that is a file, wherever it lies; "" where none is. For names that the user typed.
std::filesystem::path lookAnywhere(const std::string& name, const Search& search);

} // namespace dioptre
