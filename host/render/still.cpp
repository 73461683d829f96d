#include "render/still.h"

#include "base/clock.h"

#include <bit>
#include <cmath>
#include <vector>

namespace dioptre
{

// The finite test by bits, as shaders and fast-math builds would need it.
std::size_t countNonfinite(const Picture& picture)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.floats.size(); i += 4) {
        const auto bad = [&](std::size_t c) {
            return (std::bit_cast<std::uint32_t>(picture.floats[i + c]) & 0x7F800000U) == 0x7F800000U;
        };
        count += bad(0) || bad(1) || bad(2) ? 1 : 0;
    }
    return count;
}

PixelCounts meansOfSums(Picture& picture, int samples)
{
    PixelCounts counts;
    const float scale = 1.0F / static_cast<float>(samples);
    auto& values = picture.floats;
    for (std::size_t i = 0; i < values.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            values[i + c] *= scale;
        counts.rays += static_cast<double>(values[i + 3]);
        values[i + 3] = 1.0F;
    }
    counts.nonfinite = countNonfinite(picture);
    return counts;
}

namespace
{

// The blocks of a rectangle, none larger than the target.
std::vector<PixelRectangle> blocksOf(const PixelRectangle& region, const Drawing& drawing)
{
    std::vector<PixelRectangle> blocks;
    for (int y = 0; y < region.height; y += drawing.heightAtOnce())
        for (int x = 0; x < region.width; x += drawing.widthAtOnce())
            blocks.push_back({region.x + x, region.y + y, std::min(drawing.widthAtOnce(), region.width - x),
                              std::min(drawing.heightAtOnce(), region.height - y)});
    return blocks;
}

// What is read, and the times of drawing and reading.
Still drawBlocks(Drawing& drawing, const PixelRectangle& region, const Progress& progress)
{
    Still still;
    still.picture = blankFloats(region.width, region.height);
    Stopwatch watch;
    double done = 0.0; // pixels
    for (const auto& block : blocksOf(region, drawing)) {
        const auto pixels = static_cast<double>(block.area());
        const auto ofAll = [&](double share) {
            progress((done + share * pixels) / static_cast<double>(region.area()));
        };
        drawing.show(block);
        drawing.draw(progress ? Progress(ofAll) : Progress());
        still.phases.draw += watch.lap_ms();
        drawing.readInto(still.picture, block.x - region.x, block.y - region.y);
        still.phases.read += watch.lap_ms();
        done += pixels;
    }
    return still;
}

} // namespace

Still drawStill(Drawing& drawing, const PixelRectangle& region, const Progress& progress)
{
    Still still = drawBlocks(drawing, region, progress);
    Stopwatch watch;
    still.counts = drawing.finish(still.picture);
    still.phases.read += watch.lap_ms();
    return still;
}

Picture drawSums(Drawing& drawing, const PixelRectangle& region)
{
    return drawBlocks(drawing, region, {}).picture;
}

} // namespace dioptre
