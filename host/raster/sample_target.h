// Where one sample of a picture is rasterised before it is added to the others.
#pragma once

#include "gl/object.h"

#include <cstddef>

namespace dioptre
{

// Float32 RGBA and depth.
struct SampleTarget {
    int width = 0;  // pixels
    int height = 0; // pixels
    Texture colour;
    Texture depth;
    Framebuffer framebuffer;
};

// Throws retry without memory, noOpenGl where it cannot be drawn into.
SampleTarget makeSampleTarget(int width, int height);

// Depths alone, of shadow maps: a square of `side` texels and `layers` of them, each float32.
struct ShadowMaps {
    int side = 0; // texels
    int layers = 0;
    Texture distances; // R32F array
    Texture depth;     // for the test of a layer at a time
    Framebuffer framebuffer;
};
inline std::size_t bytesOf(const ShadowMaps& maps)
{
    return sizeof(float) * static_cast<std::size_t>(maps.side) * static_cast<std::size_t>(maps.side) *
           static_cast<std::size_t>(maps.layers);
}

// Throws badInput for more than a gibibyte, retry without memory, noOpenGl where they cannot be drawn into.
ShadowMaps makeShadowMaps(int side, int layers);

} // namespace dioptre
