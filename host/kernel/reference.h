// The tracer of glsl/, compiled as C++ in double precision: the reference that single precision is measured
// against.
#pragma once

#include "base/pixel_rectangle.h"
#include "kernel/packed_scene.h"

#include <filesystem>

namespace dioptre
{

// Renders a part of a picture of width x height pixels on all cores with the settings that the scene carries,
// `samples` a pixel. float32 means of the samples, rows from the bottom up; alpha holds the rays traced a
// sample. Throws retry where an Interruption was noted.
Picture renderReference(const PackedScene& scene, int width, int height, int samples,
                        const PixelRectangle& region);

// The fingerprint of the shader sources that the reference was compiled from, and that of a folder. Where
// they differ the reference would speak for other sources than the device runs.
unsigned long long compiledShaderFingerprint();
unsigned long long shaderFingerprint(const std::filesystem::path& glslFolder);

} // namespace dioptre
