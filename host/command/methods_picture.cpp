// What `dioptre compare --methods` draws.
#include "command/compare_methods.h"

#include "base/contact_sheet.h"
#include "base/srgb.h"
#include "base/statistics.h"
#include "base/wipe.h"
#include "metric/magma.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

Colour8 magmaColour(double share)
{
    const glm::dvec3 colour = magma(share);
    return {byteFromUnit(static_cast<float>(colour.r)), byteFromUnit(static_cast<float>(colour.g)),
            byteFromUnit(static_cast<float>(colour.b))};
}

Picture mapOf(const MethodRow& row, double scale)
{
    Picture map{row.picture.width, row.picture.height, PixelFormat::srgb8, {}, {}};
    map.bytes.reserve(4 * row.differences.size());
    for (const float difference : row.differences) {
        const Colour8 colour = magmaColour(static_cast<double>(difference) / scale);
        map.bytes.insert(map.bytes.end(), {colour.red, colour.green, colour.blue, 255});
    }
    return map;
}

Picture shownOf(const MethodRow& row, const Display& display)
{
    return toned(row.picture, display);
}

// What stands under a picture: how far it is off, and what it takes.
std::vector<std::string> linesOf(const MethodsResult& result, const MethodRow& row)
{
    const MethodRow& first = result.rows.front();
    const Estimate frame = medianOf(row.frame_ms);
    std::vector<std::string> lines;
    if (&row == &first)
        lines = {"what the others are held to", fmt::format("{:.1f} ms", frame.value)};
    else
        lines = {fmt::format("RMSE {:.4f}, SSIM {:.4f}", row.linear.rmse, row.ssim),
                 fmt::format("{:.1f} ms, {:.2f} times", frame.value,
                             ratioOfMedians(row.frame_ms, first.frame_ms).value)};
    if (const auto& raster = row.facts.raster)
        lines.push_back(fmt::format("{} objects, {} triangles", raster->drawn, raster->triangles));
    return lines;
}

DifferenceLabels labelsOf(const MethodsResult& result)
{
    DifferenceLabels labels;
    labels.caption = fmt::format("difference of radiance from {}: black 0, pale yellow {:g} and more",
                                 nameOf(result.rows.front().method), result.scale);
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i)
        labels.scale.push_back(magmaColour(static_cast<double>(i) / (steps - 1)));
    return labels;
}

} // namespace

Picture methodsPicture(const CompareOptions& options, const MethodsResult& result)
{
    const auto& rows = result.rows;
    if (options.wipe)
        return wiped(shownOf(rows[0], result.display), shownOf(rows[1], result.display), *options.wipe,
                     nameOf(rows[0].method), nameOf(rows[1].method));
    if (options.difference)
        return mapOf(rows[1], result.scale);
    std::vector<SheetColumn> columns;
    for (const auto& row : rows) {
        columns.push_back({nameOf(row.method), linesOf(result, row), shownOf(row, result.display), {}});
        if (&row != &rows.front())
            columns.back().difference = mapOf(row, result.scale);
    }
    const std::string heading =
        fmt::format("{}, {}x{}, {} sample{} a pixel, {}", result.scene, options.width, options.height,
                    options.samples, options.samples == 1 ? "" : "s", result.context.renderer);
    return contactSheet(heading, columns, labelsOf(result));
}

} // namespace dioptre
