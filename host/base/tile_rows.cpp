#include "base/tile_rows.h"

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr int groupRows = 64;

// The first row above the tiles `tile` + 1 to `tiles`, which are below.
int rowsBelow(int height, int tile, int tiles)
{
    const long long groups = mostTiles(height);
    const auto below = static_cast<int>(groups - groups * tile / tiles);
    return std::min(height, below * groupRows);
}

} // namespace

int mostTiles(int height)
{
    return (height + groupRows - 1) / groupRows;
}

TileRows tileRows(int height, int tile, int tiles)
{
    const int first = rowsBelow(height, tile, tiles);
    return {first, rowsBelow(height, tile - 1, tiles) - first};
}

} // namespace dioptre
