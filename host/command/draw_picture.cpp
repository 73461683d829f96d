#include "command/draw_picture.h"

#include "base/clock.h"
#include "base/interruption.h"
#include "base/text.h"
#include "base/tile_rows.h"
#include "render/bands.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

// What a view's picture is made from is held whole: a gibibyte of it.
constexpr long mostOfAView_px = 1L << 24;

// "2/8"
TileRows tileNamed(const std::string& text, int height)
{
    int tile = 0;
    int tiles = 0;
    if (!readPair(text, '/', tile, tiles) || tile > tiles)
        fail(ExitCode::usage, fmt::format("--tile {} is no tile", text),
             "write I/N, the I-th of N from the top, as in --tile 1/4");
    if (tiles > mostTiles(height))
        fail(ExitCode::usage,
             fmt::format("--tile {}: a picture of {} rows has no more than {} tiles", text, height,
                         mostTiles(height)),
             fmt::format("tiles are made of 64 rows: ask for at most {}", mostTiles(height)));
    return tileRows(height, tile, tiles);
}

StillForm formOf(const PictureDrawer& drawer, const RenderOptions& options)
{
    StillForm form;
    form.context = drawer.context();
    if (drawer.prepared() != nullptr)
        form.display = displayOf(options, drawer.prepared()->scene.output);
    form.layers = drawer.layerChannels();
    return form;
}

void addTo(PictureFigures& figures, const Still& still)
{
    figures.counts.rays += still.counts.rays;
    figures.counts.nonfinite += still.counts.nonfinite;
    figures.pixels += static_cast<double>(still.picture.floats.size()) / 4.0;
    figures.phases.draw += still.phases.draw;
    figures.phases.read += still.phases.read;
}

std::unique_ptr<StillWriter> open(const RenderOptions& options, const StillForm& form, int height,
                                  Video* video)
{
    return video != nullptr ? openFrame(*video, form) : openStill(options, form, height);
}

// A view for the eye takes its colours from all pixels together.
bool isForTheEye(const RenderOptions& options)
{
    const auto extension = std::filesystem::path(options.output).extension();
    return extension != ".exr" && extension != ".hdr";
}

// The rows of the picture that the options ask for: those of a tile, or all. Throws usage.
PixelRectangle rowsOf(const RenderOptions& options)
{
    if (options.tile.empty())
        return {0, 0, options.width, options.height};
    const TileRows rows = tileNamed(options.tile, options.height);
    return {0, rows.first, options.width, rows.count};
}

} // namespace

int rowsAtOnce(const RenderOptions& options)
{
    const PixelRectangle rows = rowsOf(options);
    if (options.view.empty())
        return rowsAtOnce(rows.width, rows.height);
    if (rows.area() <= mostOfAView_px && options.tile.empty())
        return rows.height;
    if (isForTheEye(options))
        fail(ExitCode::usage,
             fmt::format("--view {} takes its colours from the whole picture, and {} is drawn in parts",
                         options.view, options.tile.empty() ? "one of this size" : "a tile"),
             "write -o FILE.exr, which holds the numbers, or draw a smaller --size without --tile");
    return rowsAtOnce(rows.width, rows.height);
}

PictureFigures drawPicture(PictureDrawer& drawer, const RenderOptions& options, Video* video,
                           const Progress& progress)
{
    const PixelRectangle rows = rowsOf(options);
    StillForm form = formOf(drawer, options);
    PictureFigures figures;
    std::unique_ptr<StillWriter> writer;
    for (const PixelRectangle& band : bandsOf(rows, rowsAtOnce(options))) {
        const auto ofAll = [&](double share) {
            progress((figures.pixels + share * static_cast<double>(band.area())) /
                     static_cast<double>(rows.area()));
        };
        PictureDrawer::Band drawn = drawer.draw(band, progress ? Progress(ofAll) : Progress());
        addTo(figures, drawn.still);
        Stopwatch watch;
        if (!options.view.empty() && band.height == options.height) {
            ShownView shown = shownView(drawn.still.picture, *drawer.prepared());
            figures.legend = std::move(shown.legend);
            form.isShownView = isForTheEye(options);
            if (form.isShownView) { // numbers stand for themselves
                form.legend = &*figures.legend;
                drawn.still.picture = std::move(shown.picture);
            }
        }
        if (!writer)
            writer = open(options, form, rows.height, video);
        writer->add(drawn.still.picture, drawn.layers);
        figures.phases.write += watch.lap_ms();
        Interruption::check();
    }
    Stopwatch watch;
    writer->finish();
    figures.phases.write += watch.lap_ms();
    return figures;
}

} // namespace dioptre
