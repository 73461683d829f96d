// The line between two pictures side by side.
#pragma once

#include <algorithm>
#include <cmath>

namespace dioptre
{

// To both sides of it, where a hand takes hold of it.
inline constexpr double dividerReach_px = 6.0;

// The first column of pixels right of it. `share`: of the picture's width, left of it.
inline int dividerColumn_px(double share, int width_px)
{
    return std::clamp(static_cast<int>(std::lround(share * width_px)), 0, width_px);
}

// `x_px`: from the left edge, a pixel's centre at a half.
inline bool isOnDivider(double x_px, double share, int width_px)
{
    return std::abs(x_px - dividerColumn_px(share, width_px)) <= dividerReach_px;
}

// Where the pointer has drawn it to.
inline double dividerShareAt(double x_px, int width_px)
{
    return width_px > 0 ? std::clamp(x_px / width_px, 0.0, 1.0) : 0.5;
}

} // namespace dioptre
