// HDR-FLIP: LDR-FLIP at every exposure that a viewer might choose, the worst of them for each pixel.
// Andersson, Nilsson, Shirley and Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range
// Images", Eurographics Short Papers, 2021.
#pragma once

#include "metric/pair.h"

#include <functional>
#include <vector>

namespace dioptre
{

// From the exposure at which the reference's brightest pixel is tone mapped to 0.85 to the one at which its
// median pixel is, by luminance, in steps of at most one stop (section 3).
struct ExposureRange {
    double start = 0.0; // stops
    double stop = 0.0;  // stops; not below start
    int count = 2;      // exposures, evenly spaced, both ends included
};

// Negative numbers count as 0. Where the reference's median is 0 it is that of the pixels above 0; where the
// reference is black throughout, the picture stands in; where both are, the range is 0 to 0. Takes a linear
// pair.
ExposureRange flipExposures(const PicturePair& radiance);

// The ACES curve as HDR-FLIP takes it, Narkowicz's fit at 0.6 of the exposure, cut at 1; radiance: 0 or more.
double flipToneMapped(double radiance);

// The error of each pixel in 0..1, as ldrFlip(). `progress` is told the share of exposures done; what it
// throws is thrown on. Takes a linear pair.
std::vector<float> hdrFlip(const PicturePair& radiance, double pixelsPerDegree, const ExposureRange& range,
                           const std::function<void(double)>& progress);

} // namespace dioptre
