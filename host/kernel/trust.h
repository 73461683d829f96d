// How far a picture in single precision means anything: the account of glsl/trace/trust.glsl, kept in double
// precision.
#pragma once

#include "base/pixel_rectangle.h"
#include "kernel/packed_scene.h"

namespace dioptre
{

// Of a part of a picture of width x height pixels, as the trust view has it: red the share of the samples
// beyond trust, green the bits that are lost of 24, alpha the rays traced a sample; float32 means, rows from
// the bottom up. On all cores. Throws retry where an Interruption was noted.
Picture accountOfTrust(const PackedScene& scene, int width, int height, int samples,
                       const PixelRectangle& region);

// The share, 0..1, of a picture of that shape that is beyond trust, from a coarse grid.
double shareBeyondTrust(const PackedScene& scene, double width, double height);

} // namespace dioptre
