// Two pictures of one size, ready to be held against each other.
#pragma once

#include "base/picture.h"
#include "base/tone_curve.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dioptre
{

// Rows run from the bottom up, as in Picture; alpha is left out.
struct PicturePair {
    int width = 0;                    // pixels
    int height = 0;                   // pixels
    std::vector<glm::vec3> reference; // R, G, B of each pixel: the truth
    std::vector<glm::vec3> picture;   // what is judged
    // 0 where a number of either pixel is NaN or infinite: both are black there, so that filters may reach
    // over it, and no metric counts it. Otherwise 1.
    std::vector<std::uint8_t> judged;
    std::size_t nonfiniteReference = 0; // pixels
    std::size_t nonfinitePicture = 0;   // pixels
};

// Linear, decoded as the formats say, unclamped. The sizes must be equal.
PicturePair pairOf(const Picture& reference, const Picture& picture);

// What a display shows: linear light in 0..1, each picture after an exposure and a curve of its own. Takes a
// linear pair.
PicturePair displayed(PicturePair pair, const Display& reference, const Display& picture);

// Encoded by the sRGB curve, 0..1: what PSNR and SSIM are taken of. Takes a displayed pair.
PicturePair encoded(PicturePair displayed);

} // namespace dioptre
