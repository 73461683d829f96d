#include "base/tile_rows.h"

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr int group = 64; // rows: sums and derivatives come out the same from multiples of it

} // namespace

int mostTiles(int height)
{
    return (height + group - 1) / group;
}

TileRows tileRows(int height, int tile, int tiles)
{
    const long groups = mostTiles(height);
    const auto groupsAbove = [&](int end) { return static_cast<int>(groups * end / tiles); };
    const int first = group * (static_cast<int>(groups) - groupsAbove(tile));
    const int end = group * (static_cast<int>(groups) - groupsAbove(tile - 1));
    return {first, std::min(end, height) - first};
}

} // namespace dioptre
