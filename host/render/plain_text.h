// A plain shader's text, made into a whole program's: its own main() as it stands, or Shadertoy's mainImage()
// with what that site puts around it. The author's lines stay unchanged.
#pragma once

#include "render/source_text.h"

#include <array>
#include <filesystem>

namespace dioptre
{

enum class ChannelKind { picture, cube };

struct PlainText {
    SourceText text;
    bool mainImage = false; // Shadertoy's convention
};

// Includes are looked for beside the including file's shader and in `glslFolder`. Throws badInput (includes
// in a circle, a #version that is neither 330 core nor 300 es, neither main() nor mainImage()) and
// inputMissing.
PlainText assemblePlain(const std::filesystem::path& shader, const std::filesystem::path& glslFolder,
                        const std::array<ChannelKind, 4>& channels);

} // namespace dioptre
