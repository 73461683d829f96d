// Rows worked on together: one band a core at a time, so that memory does not grow with the picture.
#pragma once

#include "base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace dioptre
{

struct Band {
    std::size_t first = 0; // row, from the bottom
    std::size_t rows = 0;
};

inline constexpr std::size_t bandRows = 64;

inline std::size_t bandCount(std::size_t height)
{
    return (height + bandRows - 1) / bandRows;
}

inline Band bandOf(std::size_t height, std::size_t index)
{
    const std::size_t first = index * bandRows;
    return {first, std::min(bandRows, height - first)};
}

// The row of a picture that stands for one at `offset` from `first`, or beyond its ends: the nearest.
inline std::size_t nearestRow(std::size_t first, std::ptrdiff_t offset, std::size_t height)
{
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(first) + offset;
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(row, 0, static_cast<std::ptrdiff_t>(height) - 1));
}

} // namespace dioptre
