#include "render/layers.h"

#include "base/error.h"
#include "base/text.h"
#include "render/still.h"

#include <algorithm>

namespace dioptre
{
namespace
{

// One number a pixel, from the four that a view summed there.
template <typename NumberOf>
ExrLayer layerOf(const char* channel, const Picture& sums, NumberOf numberOf)
{
    ExrLayer layer{channel, {}};
    layer.numbers.reserve(sums.floats.size() / 4);
    for (std::size_t i = 0; i < sums.floats.size(); i += 4)
        layer.numbers.push_back(numberOf(&sums.floats[i]));
    return layer;
}

// The sum of n/2 + 1/2 over `met` samples as the mean of n.
float meanNormal(float sum, float met)
{
    return met > 0.0F ? 2.0F * sum / met - 1.0F : 0.0F;
}

} // namespace

const std::vector<LayerRow>& layerRows()
{
    static const std::vector<LayerRow> rows = {
        {DataView::depth, "depth", {"depth.Z"}, "metres along the ray to the first surface"},
        {DataView::normal, "normal", {"normal.X", "normal.Y", "normal.Z"}, "the first surface's normal"},
        {DataView::number, "object", {"object.id"}, "the number of the first object, -1 for none"}};
    return rows;
}

std::vector<LayerRow> layersNamed(const std::vector<std::string>& names)
{
    std::vector<std::string> known;
    for (const auto& row : layerRows())
        known.emplace_back(row.name);
    for (const auto& name : names)
        if (std::ranges::find(known, name) == known.end())
            fail(ExitCode::usage, "there is no layer called '" + name + "'",
                 "the layers are " + join(known, ", "));
    std::vector<LayerRow> rows;
    for (const auto& row : layerRows())
        if (std::ranges::find(names, row.name) != names.end())
            rows.push_back(row);
    return rows;
}

LayerDrawer::LayerDrawer(const Scene& scene, const std::vector<LayerRow>& rows, const ViewSettings& view,
                         const ContextInfo& context)
    : rows_(rows)
{
    const auto make = [&](DataView data, int samples) {
        ViewSettings own = view;
        own.view = data;
        own.samples = samples;
        auto& drawn = views_[data];
        drawn.prepared = std::make_unique<PreparedScene>(prepare(scene, own));
        drawn.renderer = std::make_unique<Renderer>(*drawn.prepared, own, context);
    };
    for (const auto& row : rows)
        make(row.view, row.view == DataView::number ? 1 : view.samples); // a number's at the pixel's centre
    // A normal's mean needs to know how many samples met something, which depth counts.
    if (views_.contains(DataView::normal) && !views_.contains(DataView::depth))
        make(DataView::depth, view.samples);
}

BuildTimes LayerDrawer::times() const
{
    BuildTimes sum;
    for (const auto& [view, drawn] : views_)
        for (const auto part : {&BuildTimes::load, &BuildTimes::compile, &BuildTimes::firstDraw})
            sum.*part += drawn.renderer->times().*part;
    return sum;
}

std::vector<SourceText> LayerDrawer::shaders() const
{
    std::vector<SourceText> all;
    for (const auto& [view, drawn] : views_)
        for (const auto& part : drawn.renderer->parts())
            all.push_back(part.shader);
    return all;
}

std::vector<std::string> LayerDrawer::channels() const
{
    std::vector<std::string> names;
    for (const auto& row : rows_)
        names.insert(names.end(), row.channels.begin(), row.channels.end());
    return names;
}

Picture LayerDrawer::sumsOf(DataView view, const PixelRectangle& region) const
{
    return drawSums(*views_.at(view).renderer, region);
}

std::vector<ExrLayer> LayerDrawer::draw(const PixelRectangle& region) const
{
    std::vector<ExrLayer> layers;
    Picture depth;
    if (views_.contains(DataView::depth))
        depth = sumsOf(DataView::depth, region);
    for (const auto& row : rows_) {
        if (row.view == DataView::depth)
            layers.push_back(layerOf(row.channels[0], depth, [](const float* sum) {
                return sum[1] > 0.0F ? sum[0] / sum[1] : 0.0F;
            }));
        if (row.view == DataView::normal) {
            const Picture normal = sumsOf(DataView::normal, region);
            for (std::size_t c = 0; c < 3; ++c)
                layers.push_back(layerOf(row.channels[c], normal, [&, c](const float* sum) {
                    return meanNormal(sum[c],
                                      depth.floats[static_cast<std::size_t>(sum - normal.floats.data() + 1)]);
                }));
        }
        if (row.view == DataView::number)
            layers.push_back(layerOf(row.channels[0], sumsOf(DataView::number, region),
                                     [](const float* sum) { return sum[0] - 1.0F; }));
    }
    return layers;
}

} // namespace dioptre
