#include "base/canvas.h"

#include <algorithm>

namespace dioptre
{
namespace
{

PixelRectangle wholeOf(const Picture& picture)
{
    return {0, 0, picture.width, picture.height};
}

std::uint8_t* pixelOf(Picture& canvas, int x, int y)
{
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    return canvas.bytes.data() + 4 * (row * static_cast<std::size_t>(canvas.width) + column);
}

void encodeTexels(const Picture& picture, int x, int y, int count, std::uint8_t* pixel)
{
    for (int end = x + count; x < end; ++x, pixel += 4) {
        const std::array<float, 4> linear = linearTexel(picture, x, y);
        std::transform(linear.begin(), linear.begin() + 3, pixel, srgb8FromLinear);
    }
}

} // namespace

Picture blankCanvas(int width, int height, Colour8 colour)
{
    Picture canvas{width, height, PixelFormat::srgb8, {}, {}};
    canvas.bytes.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < canvas.bytes.size(); i += 4) {
        canvas.bytes[i] = colour.red;
        canvas.bytes[i + 1] = colour.green;
        canvas.bytes[i + 2] = colour.blue;
        canvas.bytes[i + 3] = 255;
    }
    return canvas;
}

void blendPixel(Picture& canvas, int x, int y, Colour8 colour, float share)
{
    std::uint8_t* pixel = pixelOf(canvas, x, y);
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
        const float under = linearFromSrgb8(*pixel), over = linearFromSrgb8(channel);
        *pixel++ = srgb8FromLinear((1.0f - share) * under + share * over);
    }
}

void blendRectangle(Picture& canvas, const PixelRectangle& place, Colour8 colour, float share)
{
    const PixelRectangle seen = common(place, wholeOf(canvas));
    for (int y = seen.y; y < seen.y + seen.height; ++y)
        for (int x = seen.x; x < seen.x + seen.width; ++x)
            blendPixel(canvas, x, y, colour, share);
}

void paste(Picture& canvas, const Picture& picture, int x, int y)
{
    const PixelRectangle seen = common({x, y, picture.width, picture.height}, wholeOf(canvas));
    if (seen.width == 0)
        return;
    for (int row = seen.y; row < seen.y + seen.height; ++row) {
        std::uint8_t* to = pixelOf(canvas, seen.x, row);
        if (picture.format != PixelFormat::srgb8) {
            encodeTexels(picture, seen.x - x, row - y, seen.width, to);
            continue;
        }
        const std::size_t texel =
            static_cast<std::size_t>(row - y) * static_cast<std::size_t>(picture.width) +
            static_cast<std::size_t>(seen.x - x);
        std::copy_n(picture.bytes.data() + 4 * texel, 4 * static_cast<std::size_t>(seen.width), to);
    }
}

} // namespace dioptre
