// How a picture is shared out: tiles are bands of its full width.
#pragma once

namespace dioptre
{

// Rows [first, first + count) of the picture, counted from its bottom.
struct TileRows {
    int first = 0;
    int count = 0;
};

// Tile 1 of `tiles` is the top one. Tiles are made of groups of 64 rows from the bottom up, of which only the
// topmost may be cut off, so each is drawn in the very blocks of the whole picture.
TileRows tileRows(int height, int tile, int tiles);

// With more than these, some would hold no row.
int mostTiles(int height);

} // namespace dioptre
