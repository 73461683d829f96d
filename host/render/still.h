// From a drawing to a picture, with the time of each step.
#pragma once

#include "base/picture.h"
#include "render/drawing.h"

namespace dioptre
{

// Milliseconds by a monotonic clock, one after the other; a draw is over when the device has done it.
struct Phases {
    double context = 0.0;   // pictures are loaded beside it, by other threads
    double load = 0.0;      // scene, what is left of the pictures when the context is made, assembly, upload
    double compile = 0.0;   // compile and link
    double firstDraw = 0.0; // one pixel: drivers compile here
    double draw = 0.0;      // all samples of all pixels
    double read = 0.0;      // back to memory
    double write = 0.0;     // encode and write the file
    double total = 0.0;     // of the whole command; the context's end is part of it and of no phase above
};

// A picture or a band of one.
struct Still {
    Picture
        picture; // float32, mean of the samples, rows from the bottom up; a scene's alpha is 1; a view's data
    PixelCounts counts;
    Phases phases; // draw and read
};

// Draws a rectangle of the picture, which begins at multiples of 64 pixels, in as many blocks as the
// drawing's target asks for; its sides are multiples of 64 where there are several.
Still drawStill(Drawing& drawing, const PixelRectangle& region, const Progress& progress = {});

// The same without turning into means what was read.
Picture drawSums(Drawing& drawing, const PixelRectangle& region);

// Turns sums of `samples` in rgb into means, alpha, which counted rays, into 1, and counts.
PixelCounts meansOfSums(Picture& picture, int samples);

// Pixels with a channel, alpha apart, that is NaN or infinite.
std::size_t countNonfinite(const Picture& picture);

} // namespace dioptre
