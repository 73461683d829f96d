// A picture of any size in bands of bounded memory.
#pragma once

#include "base/pixel_rectangle.h"

#include <vector>

namespace dioptre
{

// Rows of a picture that are drawn and held at once: all where the picture has no more than so many pixels,
// else as many as have, in multiples of 64, from which sums and derivatives come out the same.
inline constexpr long pixelsAtOnce = 1L << 22;
int rowsAtOnce(int width, int height);

// The whole width of `rows` from the top down, in bands of at most `atOnce` rows; all begin at multiples of
// 64 from the bottom where `rows` and `atOnce` do.
std::vector<PixelRectangle> bandsOf(const PixelRectangle& rows, int atOnce);

} // namespace dioptre
