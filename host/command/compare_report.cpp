#include "command/compare_result.h"

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

std::string fourDigits(double value)
{
    return std::isnan(value) ? "undefined" : fmt::format("{:.4g}", value);
}

std::string linearText(const LinearError& error)
{
    std::string text =
        fmt::format("linear      RMSE {}, MAE {}, relMSE {}, largest {}", fourDigits(error.rmse),
                    fourDigits(error.mae), fourDigits(error.relmse), fourDigits(error.max));
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

std::string displayText(const CompareResult& result)
{
    const bool equal = std::isinf(result.psnr_db);
    return fmt::format(
        "display     PSNR {} (peak {}), SSIM {} ({}x{} Gaussian, sigma {}, K {} and {}, luminance); "
        "exposure {} stops, curve {}, clamped to 0..1, sRGB\n",
        equal ? "equal" : fourDigits(result.psnr_db) + " dB", psnrPeak, fourDigits(result.ssim),
        ssimWindow_px, ssimWindow_px, ssimSigma_px, ssimK1, ssimK2, result.display.exposure,
        curveName(result.display.curve));
}

std::string flipText(const CompareOptions& options, const CompareResult& result)
{
    const PooledFlip& flip = result.flip;
    std::string text = fmt::format(
        "{}    mean {}, median {}, weighted median {}, largest {}; {} pixels a degree",
        result.exposures ? "HDR-FLIP" : "LDR-FLIP", fourDigits(flip.mean), fourDigits(flip.median),
        fourDigits(flip.weightedMedian), fourDigits(flip.max), options.pixelsPerDegree);
    if (const auto& range = result.exposures)
        text += fmt::format(", {} exposures from {:.2f} to {:.2f} stops", range->count, range->start,
                            range->stop);
    return text + "\n";
}

std::string nonfiniteText(const CompareResult& result)
{
    const std::size_t reference = result.nonfiniteReference, picture = result.nonfinitePicture;
    return fmt::format("not finite  {} pixels of the reference, {} of the picture{}\n", reference, picture,
                       reference + picture > 0 ? "; left out of all figures" : "");
}

} // namespace

std::string compareText(const CompareOptions& options, const CompareResult& result)
{
    std::string text = fmt::format("reference   {}\npicture     {}\nsize        {}x{}\n", options.reference,
                                   options.picture, result.width, result.height);
    text +=
        linearText(result.linear) + displayText(result) + flipText(options, result) + nonfiniteText(result);
    if (!options.output.empty())
        text += fmt::format("difference  {}\n", options.output);
    return text;
}

// Numbers that are infinite or undefined become null.
std::string compareJson(const CompareOptions& options, const CompareResult& result)
{
    const LinearError& linear = result.linear;
    nlohmann::ordered_json json = {{"reference", options.reference},
                                   {"picture", options.picture},
                                   {"size", {result.width, result.height}}};
    json["linear"] = {{"rmse", linear.rmse},
                      {"mae", linear.mae},
                      {"relmse", linear.relmse},
                      {"max", linear.max},
                      {"max_at_px", {linear.maxX_px, linear.maxY_px}}};
    json["display"] = {{"exposure", result.display.exposure},
                       {"curve", curveName(result.display.curve)},
                       {"psnr_db", result.psnr_db},
                       {"psnr_peak", psnrPeak},
                       {"ssim", result.ssim},
                       {"ssim_window_px", ssimWindow_px},
                       {"ssim_sigma_px", ssimSigma_px},
                       {"ssim_k", {ssimK1, ssimK2}}};
    json["flip"] = {{"kind", result.exposures ? "hdr" : "ldr"},
                    {"mean", result.flip.mean},
                    {"median", result.flip.median},
                    {"weighted_median", result.flip.weightedMedian},
                    {"max", result.flip.max},
                    {"pixels_per_degree", options.pixelsPerDegree}};
    if (const auto& range = result.exposures)
        json["flip"].update(
            {{"exposure_start", range->start}, {"exposure_stop", range->stop}, {"exposures", range->count}});
    json["nonfinite"] = {{"reference", result.nonfiniteReference}, {"picture", result.nonfinitePicture}};
    json["difference"] =
        options.output.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(options.output);
    json["total_ms"] = result.total_ms;
    return jsonText(json);
}

} // namespace dioptre
