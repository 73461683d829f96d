// What the tests of drawn pictures ask of pixels.
#pragma once

#include "base/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

namespace dioptre
{

using Pixel = std::array<int, 4>; // R, G, B and alpha

inline Pixel pixelAt(const Picture& picture, int x, int y)
{
    const auto first = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(x));
    return {picture.bytes[first], picture.bytes[first + 1], picture.bytes[first + 2],
            picture.bytes[first + 3]};
}

// No two of its pixels are likely to be alike, nor those of pictures of other seeds.
inline Picture noise(int width, int height, unsigned seed)
{
    Picture picture = blankCanvas(width, height, {});
    std::mt19937 random(seed);
    for (std::uint8_t& byte : picture.bytes)
        byte = static_cast<std::uint8_t>(random() >> 24);
    return picture;
}

inline Picture cutOut(const Picture& picture, const PixelRectangle& place)
{
    Picture part = blankCanvas(place.width, place.height, {});
    paste(part, picture, -place.x, -place.y);
    return part;
}

// The least rectangle that holds all pixels that differ from `ground`; nullopt where none does.
inline std::optional<PixelRectangle> inkOf(const Picture& picture, const Pixel& ground)
{
    int left = picture.width, right = -1, bottom = picture.height, top = -1;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (pixelAt(picture, x, y) != ground) {
                left = std::min(left, x), right = std::max(right, x);
                bottom = std::min(bottom, y), top = std::max(top, y);
            }
    if (right < 0)
        return std::nullopt;
    return PixelRectangle{left, bottom, right - left + 1, top - bottom + 1};
}

// Where `part` stands in `whole` byte for byte; nullopt where it does not.
inline std::optional<PixelRectangle> placeOf(const Picture& part, const Picture& whole)
{
    for (int y = 0; y + part.height <= whole.height; ++y)
        for (int x = 0; x + part.width <= whole.width; ++x) {
            const PixelRectangle place{x, y, part.width, part.height};
            if (pixelAt(whole, x, y) == pixelAt(part, 0, 0) && cutOut(whole, place).bytes == part.bytes)
                return place;
        }
    return std::nullopt;
}

} // namespace dioptre
