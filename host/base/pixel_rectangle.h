// Part of a picture.
#pragma once

#include <algorithm>

namespace dioptre
{

// Pixels [x, x + width) x [y, y + height), from the picture's lower left corner.
struct PixelRectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    long area() const
    {
        return static_cast<long>(width) * height;
    }
};

// What two rectangles share; of no width or no height where they do not meet.
inline PixelRectangle common(const PixelRectangle& a, const PixelRectangle& b)
{
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
            std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

} // namespace dioptre
