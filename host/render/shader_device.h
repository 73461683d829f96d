// What of a device decides on a scene's shader.
#pragma once

#include "render/exact_arithmetic.h"

#include <filesystem>

namespace dioptre
{

// Most vec4 from the vertex stage to a pixel: OpenGL 3.3 demands 128 components of a fragment shader's
// inputs.
inline constexpr int mostSharedVectors = 32;

struct ShaderDevice {
    int sharedVectors = mostSharedVectors; // vec4 from the vertex stage to a pixel
    Guard guard = Guard::unit;             // what keeps compensated kernels' sums exact
};

// Of the current context. The guard is tested only where sums must be exact. OpenGL 3.3 promises 15 vectors.
ShaderDevice shaderDevice(const std::filesystem::path& glslFolder, bool exactSums = true);

} // namespace dioptre
