// Structural similarity: Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment: From Error Visibility
// to Structural Similarity", IEEE Transactions on Image Processing 13 (4), 2004.
#pragma once

#include "metric/pair.h"

namespace dioptre
{

// Section III.C: windows of 11x11 pixels under a Gaussian, C1 = (K1 L)^2 and C2 = (K2 L)^2, L = 1 being the
// range of an encoded pair.
inline constexpr int ssimWindow_px = 11;
inline constexpr double ssimSigma_px = 1.5;
inline constexpr double ssimK1 = 0.01;
inline constexpr double ssimK2 = 0.03;

// The mean over all windows that lie within the picture and have a judged pixel in their middle (equations 13
// and 17), on the luminance of encoded numbers, 0.2126 R + 0.7152 G + 0.0722 B. 1 where the pictures are
// equal, at least -1; NaN where there is no window. Takes an encoded pair.
double ssim(const PicturePair& encoded);

} // namespace dioptre
