#include "render/bands.h"

#include <algorithm>

namespace dioptre
{

int rowsAtOnce(int width, int height)
{
    constexpr int step = 64;
    const long rows = pixelsAtOnce / width;
    return rows >= height ? height : std::max(step, static_cast<int>(rows / step) * step);
}

std::vector<PixelRectangle> bandsOf(const PixelRectangle& rows, int atOnce)
{
    std::vector<PixelRectangle> bands;
    for (int y = 0; y < rows.height; y += atOnce)
        bands.push_back({rows.x, rows.y + y, rows.width, std::min(atOnce, rows.height - y)});
    std::ranges::reverse(bands);
    return bands;
}

} // namespace dioptre
