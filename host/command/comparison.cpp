#include "command/comparison.h"

#include "command/json_text.h"
#include "metric/psnr.h"
#include "metric/ssim.h"
#include "scene/choices.h"

#include <fmt/format.h>

#include <cmath>

namespace dioptre
{
namespace
{

std::string figure(double value)
{
    return std::isnan(value) ? "undefined" : fmt::format("{:.4g}", value);
}

std::string linearText(const LinearError& error)
{
    std::string text = fmt::format("linear      RMSE {}, MAE {}, relMSE {}, largest {}", figure(error.rmse),
                                   figure(error.mae), figure(error.relmse), figure(error.max));
    if (error.max > 0.0)
        text += fmt::format(" at {},{} from the upper left", error.maxX_px, error.maxY_px);
    return text + "; unclamped\n";
}

std::string_view curveName(ToneCurve curve)
{
    for (const auto& row : toneCurves)
        if (row.choice == curve)
            return row.name;
    return "";
}

std::string displayText(const Comparison& comparison)
{
    const bool equal = std::isinf(comparison.psnr_db);
    return fmt::format(
        "display     PSNR {} (peak {}), SSIM {} ({}x{} Gaussian, sigma {}, K {} and {}, luminance); "
        "exposure {} stops, curve {}, clamped to 0..1, sRGB\n",
        equal ? "equal" : figure(comparison.psnr_db) + " dB", psnrPeak, figure(comparison.ssim),
        ssimWindow_px, ssimWindow_px, ssimSigma_px, ssimK1, ssimK2, comparison.display.exposure,
        curveName(comparison.display.curve));
}

std::string flipText(const CompareOptions& options, const Comparison& comparison)
{
    const PooledFlip& flip = comparison.flip;
    std::string text =
        fmt::format("{}    mean {}, median {}, weighted median {}, largest {}; {} pixels a degree",
                    comparison.exposures ? "HDR-FLIP" : "LDR-FLIP", figure(flip.mean), figure(flip.median),
                    figure(flip.weightedMedian), figure(flip.max), options.pixelsPerDegree);
    if (const auto& range = comparison.exposures)
        text += fmt::format(", {} exposures from {:.2f} to {:.2f} stops", range->count, range->start,
                            range->stop);
    return text + "\n";
}

std::string nonfiniteText(const Comparison& comparison)
{
    const std::size_t reference = comparison.nonfiniteReference, picture = comparison.nonfinitePicture;
    return fmt::format("not finite  {} pixels of the reference, {} of the picture{}\n", reference, picture,
                       reference + picture > 0 ? "; left out of all figures" : "");
}

} // namespace

std::string comparisonText(const CompareOptions& options, const Comparison& comparison)
{
    std::string text = fmt::format("reference   {}\npicture     {}\nsize        {}x{}\n", options.reference,
                                   options.picture, comparison.width, comparison.height);
    text += linearText(comparison.linear) + displayText(comparison) + flipText(options, comparison) +
            nonfiniteText(comparison);
    if (!options.output.empty())
        text += fmt::format("difference  {}\n", options.output);
    return text;
}

// Numbers that are infinite or undefined become null.
std::string comparisonJson(const CompareOptions& options, const Comparison& comparison)
{
    const LinearError& linear = comparison.linear;
    nlohmann::ordered_json json = {{"reference", options.reference},
                                   {"picture", options.picture},
                                   {"size", {comparison.width, comparison.height}}};
    json["linear"] = {{"rmse", linear.rmse},
                      {"mae", linear.mae},
                      {"relmse", linear.relmse},
                      {"max", linear.max},
                      {"max_at_px", {linear.maxX_px, linear.maxY_px}}};
    json["display"] = {{"exposure", comparison.display.exposure},
                       {"curve", curveName(comparison.display.curve)},
                       {"psnr_db", comparison.psnr_db},
                       {"psnr_peak", psnrPeak},
                       {"ssim", comparison.ssim},
                       {"ssim_window_px", ssimWindow_px},
                       {"ssim_sigma_px", ssimSigma_px},
                       {"ssim_k", {ssimK1, ssimK2}}};
    json["flip"] = {{"kind", comparison.exposures ? "hdr" : "ldr"},
                    {"mean", comparison.flip.mean},
                    {"median", comparison.flip.median},
                    {"weighted_median", comparison.flip.weightedMedian},
                    {"max", comparison.flip.max},
                    {"pixels_per_degree", options.pixelsPerDegree}};
    if (const auto& range = comparison.exposures)
        json["flip"].update(
            {{"exposure_start", range->start}, {"exposure_stop", range->stop}, {"exposures", range->count}});
    json["nonfinite"] = {{"reference", comparison.nonfiniteReference},
                         {"picture", comparison.nonfinitePicture}};
    json["difference"] =
        options.output.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(options.output);
    json["total_ms"] = comparison.total_ms;
    return jsonText(json);
}

} // namespace dioptre
