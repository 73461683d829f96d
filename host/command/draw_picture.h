// From a drawer to a picture's file, band by band: the memory that a picture takes does not grow with it.
#pragma once

#include "command/picture_drawer.h"
#include "command/still_writer.h"

namespace dioptre
{

// What drawing and writing a picture gave.
struct PictureFigures {
    PixelCounts counts;
    double pixels = 0.0;              // that were drawn
    Phases phases;                    // draw, read, write
    std::optional<ViewLegend> legend; // of a view that was drawn at once

    double raysPerPixel() const
    {
        return counts.rays / pixels;
    }
};

// How many rows of what the options ask for are drawn at once. A view for the eye looks at the whole picture:
// throws usage where it is too large.
int rowsAtOnce(const RenderOptions& options);

// Draws what the options ask for, as it is at the drawer's time, and writes it: to the file that the options
// name, or as the next frame of `video` where there is one.
PictureFigures drawPicture(PictureDrawer& drawer, const RenderOptions& options, Video* video,
                           const Progress& progress);

} // namespace dioptre
