#include "command/stability_scales.h"

#include "base/write_file.h"
#include "command/log_chart.h"
#include "stability/scale_sweep.h"

namespace dioptre
{

void writeScalePlot(const KernelDevice& device, const StabilityOptions& options)
{
    constexpr std::size_t raysAPoint = 2000;
    constexpr std::array colours = {"#c0392b", "#e08e0b", "#1f7a4d", "#2c5aa0"}; // as variantNames
    LogChart chart{"Sphere 1 m from the eye: worst error of 2,000 rays a radius",
                   "radius, m",
                   "the larger of relative t and the normal's angle, rad",
                   -5,
                   8,
                   -8,
                   1,
                   {}};
    for (const VariantName& variant : variantNames) {
        ChartLine line{std::string(variant.name), colours.at(static_cast<std::size_t>(variant.variant)), {}};
        for (const ScalePoint& point : sweepScales(device, variant.variant, options.seed, raysAPoint))
            line.points.emplace_back(point.radius_m, std::max(point.error, 1.0e-8));
        chart.lines.push_back(std::move(line));
    }
    writeFile(options.plot, svgOf(chart));
}

} // namespace dioptre
