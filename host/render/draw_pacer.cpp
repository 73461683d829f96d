#include "render/draw_pacer.h"

#include "gl/wait.h"

#include <algorithm>
#include <vector>

namespace dioptre
{
namespace
{

// A draw is to take no longer, as far as those before it tell; watchdogs bite after two seconds and more.
constexpr double mostForADraw_ms = 100.0;

// Between two waits, as far as can be told; progress has to wait as long.
constexpr double mostBetweenWaits_ms = 200.0;

// However cheap the pixels before them were: those that follow may cost a thousand times as much.
constexpr int mostDrawsBetweenWaits = 4;

} // namespace

void DrawPacer::begin(long pixels, const Progress& progress)
{
    progress_ = progress;
    all_ = pixels;
    drawn_ = 0;
    waiting_ = 0;
    draws_ = 0;
    sinceWait_.lap_ms();
}

void DrawPacer::cover(const PixelRectangle& area, const std::function<void(const PixelRectangle&)>& draw)
{
    std::vector<PixelRectangle> left = {area};
    while (!left.empty()) {
        const PixelRectangle r = left.back();
        left.pop_back();
        if (r.area() == 0)
            continue;
        const int width = std::min(side_px_, r.width);
        const int height = std::min(side_px_, r.height);
        left.push_back({r.x, r.y + height, r.width, r.height - height});
        left.push_back({r.x + width, r.y, r.width - width, height});
        draw({r.x, r.y, width, height});
        waiting_ += static_cast<long>(width) * height;
        ++draws_;
        if (isTimeToWait())
            wait();
    }
}

void DrawPacer::finish()
{
    if (draws_ > 0)
        wait();
}

bool DrawPacer::isTimeToWait() const
{
    return side_px_ < mostSide_px || draws_ == mostDrawsBetweenWaits ||
           msPerPixel_ * static_cast<double>(waiting_) > mostBetweenWaits_ms;
}

void DrawPacer::wait()
{
    waitForDevice(limit_s_ * draws_);
    msPerPixel_ = sinceWait_.lap_ms() / static_cast<double>(waiting_);
    drawn_ += waiting_;
    waiting_ = 0;
    draws_ = 0;
    const auto timeOf = [&](int side_px) { return msPerPixel_ * static_cast<double>(side_px) * side_px; };
    for (int step = 0; step < 3 && side_px_ < mostSide_px && timeOf(2 * side_px_) < mostForADraw_ms; ++step)
        side_px_ *= 2;
    while (side_px_ > leastSide_px && timeOf(side_px_) > 2.0 * mostForADraw_ms)
        side_px_ /= 2;
    if (progress_)
        progress_(static_cast<double>(drawn_) / static_cast<double>(all_));
}

} // namespace dioptre
