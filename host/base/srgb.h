// The sRGB curve as a formula, for pictures of more than 8 bits.
#pragma once

#include <cstdint>

namespace dioptre
{

// IEC 61966-2-1 in double precision; `encoded` in 0..1.
double linearFromSrgb(double encoded);

// The inverse, without clamping.
double srgbFromLinear(double linear);

// 255 times the value, rounded to nearest; values outside 0..1 are clamped, NaN gives 0.
std::uint8_t byteFromUnit(float value);

} // namespace dioptre
