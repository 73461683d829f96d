#include "base/picture.h"

#include "base/srgb.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace dioptre
{
namespace
{

// One level in linear light, kept unrounded so that errors of 8 bits do not pile up along the chain.
struct LinearLevel {
    int width = 0;
    int height = 0;
    std::vector<float> floats; // RGBA
};

using Texel = std::array<float, 4>;

// Each texel is the mean of a 2x2 block. The last row or column of an odd size is left out, and one of size 1
// counts twice. `texelAt(x, y)` gives the linear RGBA of the larger level.
template <typename TexelAt>
LinearLevel halve(int width, int height, const TexelAt& texelAt)
{
    LinearLevel half{std::max(1, width / 2), std::max(1, height / 2), {}};
    half.floats.reserve(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        const int below = 2 * y, above = std::min(2 * y + 1, height - 1);
        for (int x = 0; x < half.width; ++x) {
            const int left = 2 * x, right = std::min(2 * x + 1, width - 1);
            const Texel a = texelAt(left, below), b = texelAt(right, below);
            const Texel c = texelAt(left, above), d = texelAt(right, above);
            for (std::size_t channel = 0; channel < 4; ++channel)
                half.floats.push_back(0.25f * ((a[channel] + b[channel]) + (c[channel] + d[channel])));
        }
    }
    return half;
}

std::size_t texelIndex(int width, int x, int y)
{
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
}

Picture stored(const LinearLevel& level, PixelFormat format)
{
    Picture picture{level.width, level.height, format, {}, {}};
    if (format == PixelFormat::float32) {
        picture.floats = level.floats;
        return picture;
    }
    picture.bytes.resize(level.floats.size());
    for (std::size_t i = 0; i < level.floats.size(); ++i) {
        const bool isColour = format == PixelFormat::srgb8 && i % 4 < 3;
        picture.bytes[i] = isColour ? srgb8FromLinear(level.floats[i]) : byteFromUnit(level.floats[i]);
    }
    return picture;
}

} // namespace

Texel linearTexel(const Picture& picture, int x, int y)
{
    const std::size_t first = texelIndex(picture.width, x, y);
    Texel texel;
    for (std::size_t channel = 0; channel < 4; ++channel) {
        if (picture.format == PixelFormat::float32)
            texel[channel] = picture.floats[first + channel];
        else if (picture.format == PixelFormat::srgb8 && channel < 3)
            texel[channel] = linearFromSrgb8(picture.bytes[first + channel]);
        else
            texel[channel] = static_cast<float>(picture.bytes[first + channel]) / 255.0f;
    }
    return texel;
}

std::vector<Picture> mipmaps(Picture picture)
{
    std::vector<Picture> levels;
    levels.push_back(std::move(picture));
    const Picture& whole = levels.front();
    const PixelFormat format = whole.format;
    if (whole.width <= 1 && whole.height <= 1)
        return levels;
    LinearLevel level =
        halve(whole.width, whole.height, [&whole](int x, int y) { return linearTexel(whole, x, y); });
    levels.push_back(stored(level, format));
    while (level.width > 1 || level.height > 1) {
        level = halve(level.width, level.height, [&level](int x, int y) {
            const float* texel = level.floats.data() + texelIndex(level.width, x, y);
            return Texel{texel[0], texel[1], texel[2], texel[3]};
        });
        levels.push_back(stored(level, format));
    }
    return levels;
}

} // namespace dioptre
