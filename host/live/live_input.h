// What a window can be asked to show.
#pragma once

#include "command/input.h"

namespace dioptre
{

struct LiveInput : Input {
    std::string picture;   // where a picture file is shown, by a shader of our own; "" else
    bool isLinear = false; // the picture holds radiance

    // What the user named.
    std::filesystem::path shownFile() const
    {
        return picture.empty() ? path : std::filesystem::path(picture);
    }
};

// As findInput(), and pictures by their extension. Throws inputMissing.
LiveInput findLiveInput(const std::string& text);

} // namespace dioptre
