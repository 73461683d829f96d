// Where the program's own files are, and what a user's SCENE or SHADER means.
#pragma once

#include "base/picture_cache.h"
#include "base/search_places.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

// The folder glsl/: $DIOPTRE_GLSL where set, else the one beside the program or above it. Throws
// inputMissing.
std::filesystem::path glslFolder();

// The program's own files, and the folders of --include.
SearchPlaces searchPlaces(const std::vector<std::string>& included = {});

// Where prepared pictures are kept: $DIOPTRE_CACHE, "off" for nowhere; without it dioptre/ in $XDG_CACHE_HOME
// or in ~/.cache.
PictureCache pictureCache();

// Names of the gallery's scenes, sorted; and of its plain shaders.
std::vector<std::string> galleryNames();
std::vector<std::string> galleryShaders();

struct Input {
    std::filesystem::path path;
    std::string name; // without folder and extension
    bool plainShader = false;
};

// A gallery name, a .toml file, or a .frag/.glsl file. Throws inputMissing with the nearest gallery name.
Input findInput(const std::string& text);

} // namespace dioptre
