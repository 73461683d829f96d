// Which objects each tile of a picture may show, and the parts of the picture for which less of the shader
// will do: where the eye sees the sky alone, or a few objects that send no ray on, nothing else is asked for
// but to cast shadows.
#pragma once

#include "base/pixel_rectangle.h"
#include "render/plan.h"

#include <string>
#include <vector>

namespace dioptre
{

struct PicturePart {
    std::string name;                       // "sky", "2 of 10 objects", "everything"
    std::vector<bool> seen;                 // by object: whether it may be seen there
    std::vector<PixelRectangle> rectangles; // in whole tiles, but for the picture's right and upper edge
};

// Of tiles: their sides, in pixels. Halved, they gain nothing more on llvmpipe; doubled where a large picture
// would have too many to look at each in no time.
constexpr int partTile_px(int width, int height)
{
    constexpr double most = 1 << 18;
    int side = 32;
    while (static_cast<double>(width) * height / side / side > most)
        side *= 2;
    return side;
}

// By tile, row by row from the lower left, and by object: whether an eye ray of the tile may meet it. Errs
// towards yes: by a quarter of a pixel, and by what floats lose.
std::vector<std::vector<bool>> seenInTiles(const Scene& scene, int width, int height);

// The picture cut into parts, no pixel left out and none in two, the fullest last. That is "everything", and
// may be all there is, unless no tile needs it. Each other one is at least an eighth of the tiles, so that it
// outweighs a program of its own.
std::vector<PicturePart> pictureParts(const Scene& scene, const Plan& plan, int width, int height);

PicturePart wholePicture(const Plan& plan, int width, int height);

// Whether the picture is cut: plan.tiles is on, or auto and so many samples are drawn in all that the
// programs are worth their compilation. Never where the scene is animated, in a table, forced or viewed as
// data.
bool cutsPicture(const Scene& scene, const Plan& plan, long samples);

} // namespace dioptre
