// How much of a picture goes into one draw, and when the device is waited for.
#pragma once

#include "base/clock.h"
#include "base/pixel_rectangle.h"

#include <functional>

namespace dioptre
{

// Told the share that is done, 0..1; may be empty.
using Progress = std::function<void(double)>;

// Cuts areas into draws that each take little time: a graphics card's watchdog ends what takes seconds, and
// Ctrl-C waits for the end of a draw. The first draws are small and waited for; as their times come in, draws
// grow and are waited for a few at a time, so that waiting costs nothing that can be seen. What is drawn does
// not hang on it: a pixel is the same in every draw.
class DrawPacer
{
public:
    // `limit_s`: no draw may take longer, see waitForDevice().
    explicit DrawPacer(double limit_s) : limit_s_(limit_s) {}

    // A new picture of so many pixels, each counted as often as it is drawn.
    void begin(long pixels, const Progress& progress);

    // Calls draw(piece) for pieces that cover the area, each pixel once.
    void cover(const PixelRectangle& area, const std::function<void(const PixelRectangle&)>& draw);

    // Waits for what is under way.
    void finish();

private:
    bool isTimeToWait() const;
    void wait();

    double limit_s_;
    int side_px_ = leastSide_px; // of a draw
    double msPerPixel_ = 0.0;    // of the draws that were last waited for
    Stopwatch sinceWait_;
    long waiting_ = 0; // pixels drawn since then
    int draws_ = 0;    // likewise
    long drawn_ = 0;   // pixels of the picture that are known to be done
    long all_ = 0;
    Progress progress_;

    static constexpr int leastSide_px = 16;
    static constexpr int mostSide_px = 512;
};

} // namespace dioptre
