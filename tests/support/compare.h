// Differences of two pictures, and where to look at them when a test fails.
#pragma once

#include "base/picture.h"

#include <string>

namespace dioptre::test
{

struct Difference {
    double rmse = 0.0;    // over pixels and colour channels, unclamped
    double largest = 0.0; // of a channel
    std::size_t over = 0; // pixels with a channel off by more than the threshold
    std::size_t pixels = 0;
};

// Both float32 and of one size, or the test is ill made (throws).
Difference compare(const Picture& actual, const Picture& expected, double threshold);

// The same after clamping to 0..1 and sRGB-encoding to 8 bits; `largest` and `threshold` count steps of 255.
Difference compareEncoded(const Picture& actual, const Picture& expected, double threshold);

// Writes NAME-actual.exr, NAME-expected.exr and NAME-difference.exr to tests/output/ and says so.
std::string saveForTheEye(const std::string& name, const Picture& actual, const Picture& expected);

// float32 linear values of an 8-bit picture; others as they are.
Picture decoded(const Picture& picture);

} // namespace dioptre::test
