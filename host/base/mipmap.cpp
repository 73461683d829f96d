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

// What each byte of a channel stands for.
using Table = std::array<float, 256>;

Table unitTable()
{
    Table table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte)
        table[byte] = static_cast<float>(byte) / 255.0f;
    return table;
}

Table srgbTable()
{
    Table table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte)
        table[byte] = linearFromSrgb8(static_cast<std::uint8_t>(byte));
    return table;
}

// Each texel is the mean of a 2x2 block. The last row or column of an odd size is left out, and one of size 1
// counts twice. `linear(channel, number)` decodes a number of the larger level, whose RGBA begin at
// `numbers`.
template <typename Number, typename Linear>
LinearLevel halve(int width, int height, const Number* numbers, const Linear& linear)
{
    LinearLevel half{std::max(1, width / 2), std::max(1, height / 2), {}};
    half.floats.resize(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const std::size_t right = width > 1 ? 4 : 0;
    const std::size_t row = 4 * static_cast<std::size_t>(width);
    const std::size_t above = height > 1 ? row : 0;
    float* mean = half.floats.data();
    for (int y = 0; y < half.height; ++y) {
        const Number* a = numbers + 2 * static_cast<std::size_t>(y) * row;
        for (int x = 0; x < half.width; ++x, a += 8)
            for (std::size_t c = 0; c < 4; ++c)
                *mean++ = 0.25f * ((linear(c, a[c]) + linear(c, a[right + c])) +
                                   (linear(c, a[above + c]) + linear(c, a[above + right + c])));
    }
    return half;
}

LinearLevel halve(const LinearLevel& level)
{
    return halve(level.width, level.height, level.floats.data(),
                 [](std::size_t, float number) { return number; });
}

LinearLevel halve(const Picture& picture)
{
    if (picture.format == PixelFormat::float32)
        return halve(picture.width, picture.height, picture.floats.data(),
                     [](std::size_t, float number) { return number; });
    const Table alpha = unitTable();
    const Table colour = picture.format == PixelFormat::srgb8 ? srgbTable() : alpha;
    return halve(
        picture.width, picture.height, picture.bytes.data(),
        [&](std::size_t channel, std::uint8_t byte) { return channel < 3 ? colour[byte] : alpha[byte]; });
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

std::array<float, 4> linearTexel(const Picture& picture, int x, int y)
{
    const std::size_t first = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                   static_cast<std::size_t>(x));
    std::array<float, 4> texel;
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
    LinearLevel level = halve(whole);
    levels.push_back(stored(level, format));
    while (level.width > 1 || level.height > 1) {
        level = halve(level);
        levels.push_back(stored(level, format));
    }
    return levels;
}

} // namespace dioptre
