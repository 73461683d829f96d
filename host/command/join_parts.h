// What tiles say of the picture that they are parts of, and whether they make it up.
#pragma once

#include "base/picture_stack.h"

namespace dioptre
{

struct TiledPicture {
    StoredKind kind = StoredKind::png;
    int width = 0;  // pixels
    int height = 0; // pixels
    std::vector<std::string> topDown{};
    Settings settings{}; // as one machine would have written them
};

// Reads what stands before the pixels of the files, which may come in any order. Throws badInput, naming file
// and mend, unless they are all the tiles of one picture, each once; inputMissing.
TiledPicture tiledPicture(const std::vector<std::string>& parts);

// For messages.
std::string_view nameOf(StoredKind kind);

} // namespace dioptre
