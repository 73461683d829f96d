// LDR-FLIP, the difference that a viewer sees who alternates between two displayed pictures: Andersson et
// al., "FLIP: A Difference Evaluator for Alternating Images", 2020.
#pragma once

#include "metric/pair.h"

#include <vector>

namespace dioptre
{

// A display of 3840 pixels on 0.7 m, seen from 0.7 m: 0.7 m * 3840 / 0.7 m * pi / 180.
inline constexpr double usualPixelsPerDegree = 67.0;

// The error of each pixel in 0..1, rows from the bottom up; alike, whichever of the two is the reference.
// Pictures go on beyond their edges with the nearest pixel. Takes a displayed pair; pixelsPerDegree: 1 or
// more.
std::vector<float> ldrFlip(const PicturePair& displayed, double pixelsPerDegree);

// What a map of errors comes to over the judged pixels; all are NaN where there is none.
struct PooledFlip {
    double mean = 0.0;
    double median = 0.0;
    double weightedMedian = 0.0; // half of the sum of all errors lies in pixels up to it (2020, section 5)
    double max = 0.0;
};
PooledFlip pooled(const std::vector<float>& errors, const std::vector<std::uint8_t>& judged);

} // namespace dioptre
