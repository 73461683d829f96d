#include "render/layers.h"

#include "base/error.h"
#include "base/text.h"
#include "render/renderer.h"

#include <algorithm>

namespace dioptre
{
namespace
{

// The sums of a view's samples.
Picture sumsOf(const Scene& scene, DataView view, ViewSettings settings, const ContextInfo& context)
{
    settings.view = view;
    const PreparedScene prepared = prepare(scene, settings);
    Renderer renderer(prepared, settings, context);
    renderer.draw();
    return renderer.read();
}

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

std::vector<ExrLayer> drawLayers(const Scene& scene, const std::vector<LayerRow>& rows,
                                 const ViewSettings& view, const ContextInfo& context)
{
    std::vector<ExrLayer> layers;
    const auto asks = [&rows](DataView wanted) {
        return std::ranges::find(rows, wanted, &LayerRow::view) != rows.end();
    };
    // A normal's mean needs to know how many samples met something, which depth counts.
    Picture depth;
    if (asks(DataView::depth) || asks(DataView::normal))
        depth = sumsOf(scene, DataView::depth, view, context);
    for (const auto& row : rows) {
        if (row.view == DataView::depth)
            layers.push_back(layerOf(row.channels[0], depth, [](const float* sum) {
                return sum[1] > 0.0F ? sum[0] / sum[1] : 0.0F;
            }));
        if (row.view == DataView::normal) {
            const Picture normal = sumsOf(scene, DataView::normal, view, context);
            for (std::size_t c = 0; c < 3; ++c)
                layers.push_back(layerOf(row.channels[c], normal, [&, c](const float* sum) {
                    return meanNormal(sum[c],
                                      depth.floats[static_cast<std::size_t>(sum - normal.floats.data() + 1)]);
                }));
        }
        if (row.view == DataView::number) {
            ViewSettings centre = view;
            centre.samples = 1;
            const Picture number = sumsOf(scene, DataView::number, centre, context);
            layers.push_back(
                layerOf(row.channels[0], number, [](const float* sum) { return sum[0] - 1.0F; }));
        }
    }
    return layers;
}

} // namespace dioptre
