// Pictures are rasterised in cells of a fixed grid, so that a tile's pixels are rounded as the whole picture's are, and so that
// no viewport is too large for a driver. Pixels on a side.
const int CELL_PX = 2048;
