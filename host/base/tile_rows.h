// How a picture is parted into tiles for several machines.
#pragma once

namespace dioptre
{

struct TileRows {
    int first = 0; // the lowest, counted from the bottom of the picture; a multiple of 64
    int count = 0;
};

// The most tiles of a picture of so many rows: tiles are made of groups of 64 rows, from the bottom.
int mostTiles(int height);

// Tile `tile` of `tiles`, counted from 1 and from the top; 1 <= tile <= tiles <= mostTiles(height).
TileRows tileRows(int height, int tile, int tiles);

} // namespace dioptre
