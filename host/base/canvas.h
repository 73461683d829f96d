// A picture of 8 bits to draw on.
#pragma once

#include "base/picture.h"
#include "base/pixel_rectangle.h"

#include <cstdint>

namespace dioptre
{

// sRGB-encoded.
struct Colour8 {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};

// srgb8, opaque, of one colour.
Picture blankCanvas(int width, int height, Colour8 colour);

// The others draw on srgb8 pictures, whose alpha they leave alone. Places count from the lower left corner;
// what lies outside of the picture is left out.

// Mixes the colour in, in linear light: `share` of it, 0 to 1. The pixel lies within the picture.
void blendPixel(Picture& canvas, int x, int y, Colour8 colour, float share);

// The same for each pixel of a rectangle.
void blendRectangle(Picture& canvas, const PixelRectangle& place, Colour8 colour, float share = 1.0f);

// Puts a picture's lower left corner to x, y. Bytes of srgb8 stay as they are, with their alpha; linear
// numbers are clamped to 0..1 and encoded.
void paste(Picture& canvas, const Picture& picture, int x, int y);

} // namespace dioptre
