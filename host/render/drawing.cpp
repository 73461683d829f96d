#include "render/drawing.h"

#include "gl/wait.h"

#include <glad/gl.h>

namespace dioptre
{

Drawing::Drawing(int width, int height, double drawLimit_s)
    : region_{0, 0, width, height}, target_(makeAccumulationTarget(width, height)), pacer_(drawLimit_s),
      drawLimit_s_(drawLimit_s)
{
}

void Drawing::show(const PixelRectangle& region)
{
    region_ = region;
}

void Drawing::submit()
{
    submit({});
}

void Drawing::submit(const Progress& progress)
{
    pacer_.begin(region_.area() * static_cast<long>(batches().size()), progress);
    clear(target_);
    drawBatches(batches(), region_);
}

void Drawing::draw(const Progress& progress)
{
    submit(progress);
    pacer_.finish();
}

void Drawing::start()
{
    clear(target_);
}

void Drawing::add(const SampleBatch& batch, const PixelRectangle& area)
{
    pacer_.begin(area.area(), {});
    drawBatches({&batch, 1}, area);
    pacer_.finish();
}

void Drawing::resize(int width, int height)
{
    if (width != target_.width || height != target_.height)
        target_ = makeAccumulationTarget(width, height);
    region_ = {0, 0, width, height};
}

void Drawing::waitForFirst() const
{
    waitForDevice(drawLimit_s_);
}

void Drawing::cover(const PixelRectangle& area)
{
    pacer_.cover(common(area, region_), [&](const PixelRectangle& piece) {
        drawAdding(target_, piece.x - region_.x, piece.y - region_.y, piece.width, piece.height);
    });
}

void Drawing::drawFirst()
{
    drawAdding(target_, 0, 0, 1, 1);
}

void Drawing::readInto(Picture& picture, int x, int y) const
{
    readBackInto(picture, x, y, target_, region_.width, region_.height);
}

Picture Drawing::read() const
{
    Picture picture = blankFloats(region_.width, region_.height);
    readInto(picture, 0, 0);
    return picture;
}

} // namespace dioptre
