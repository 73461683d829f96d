// What the current context can take.
#pragma once

#include <string_view>

namespace dioptre
{

struct DeviceLimits {
    int pictureSide_px = 0; // the least of texture and viewport sizes: what can be drawn into at once
    int textureSide_px = 0;
    int viewportWidth_px = 0;
    int viewportHeight_px = 0;
    int arrayLayers = 0;
    int uniformBlock_bytes = 0;
    int fragmentUniformBlocks = 0;
    int fragmentUniformComponents = 0; // numbers outside blocks
    int fragmentTextureUnits = 0;
    bool gpuShader5 = false;     // GL_ARB_gpu_shader5: `precise` and fma()
    bool drawsIntoFloat = false; // float32 RGBA textures can be drawn into
};

DeviceLimits deviceLimits();

} // namespace dioptre
