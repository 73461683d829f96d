// Peak signal-to-noise ratio.
#pragma once

#include "metric/pair.h"

namespace dioptre
{

inline constexpr double psnrPeak = 1.0; // the largest number of an encoded pair

// 10 log10(peak^2 / MSE) in decibels, the mean square error over R, G and B of all judged pixels; infinite
// where the pictures are equal, NaN where no pixel is judged. Takes an encoded pair.
double psnr_db(const PicturePair& encoded);

} // namespace dioptre
