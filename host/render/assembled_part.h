// The texts of the programs that draw a scene, before there is a device.
#pragma once

#include "render/assemble.h"
#include "render/prepare.h"

namespace dioptre
{

// A part of the picture with its own plan and shaders.
struct AssembledPart {
    PicturePart part;
    Plan plan; // for this part, cut to what the device carries
    SourceText shader;
    SourceText vertex;
};

// Of all parts, the fullest last. Throws as assemble().
std::vector<AssembledPart> assembleParts(const PreparedScene& prepared,
                                         const std::filesystem::path& glslFolder, const ShaderDevice& device);

} // namespace dioptre
