// Small pictures for the tests of metrics.
#pragma once

#include "metric/pair.h"

#include <functional>
#include <random>

namespace dioptre::test
{

// The colour of each pixel, columns from the left and rows from the bottom.
using Painter = std::function<glm::vec3(int x, int y)>;

inline Picture painted(int width, int height, const Painter& colourAt)
{
    Picture picture = blankFloats(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec3 colour = colourAt(x, y);
            float* texel = picture.floats.data() + 4 * (y * width + x);
            texel[0] = colour.r;
            texel[1] = colour.g;
            texel[2] = colour.b;
            texel[3] = 1.0f;
        }
    return picture;
}

inline PicturePair pairOf(int width, int height, const Painter& reference, const Painter& picture)
{
    return dioptre::pairOf(painted(width, height, reference), painted(width, height, picture));
}

inline Painter uniform(const glm::vec3& colour)
{
    return [colour](int, int) { return colour; };
}

// Independent numbers of 0 to `most`; the same seed paints the same picture.
inline Painter noise(unsigned seed, float most = 1.0f)
{
    return [random = std::mt19937(seed), most](int, int) mutable {
        std::uniform_real_distribution<float> number(0.0f, most);
        const float r = number(random), g = number(random);
        return glm::vec3(r, g, number(random));
    };
}

} // namespace dioptre::test
