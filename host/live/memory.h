// What is remembered of an input from one window to the next, in the user's state folder.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>

namespace dioptre
{

struct Remembered {
    glm::ivec2 size_px{0};      // of the picture in the window; 0 for none
    bool panel = true;          // whether it was shown
    std::optional<Camera> hand; // where the camera was moved to
    Camera own;                 // the scene's, from which it was moved
};

// Nothing where nothing is kept of this input, or what is kept cannot be read.
std::optional<Remembered> recall(const std::filesystem::path& input);

// In $XDG_STATE_HOME/dioptre or ~/.local/state/dioptre, which is made. Throws cannotWrite.
void remember(const std::filesystem::path& input, const Remembered& what);

} // namespace dioptre
