#include "command/compare.h"

#include "base/clock.h"
#include "base/interruption.h"
#include "command/compare_input.h"
#include "command/compare_methods.h"
#include "command/compare_result.h"
#include "command/difference_picture.h"
#include "command/display_option.h"
#include "command/progress.h"
#include "metric/psnr.h"
#include "metric/ssim.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

std::vector<float> flipErrors(const CompareOptions& options, const ComparedPictures& compared,
                              const PicturePair& shown, const std::optional<ExposureRange>& exposures)
{
    if (!exposures)
        return ldrFlip(shown, options.pixelsPerDegree);
    const auto tell = terminalProgress();
    return hdrFlip(compared.pair, options.pixelsPerDegree, *exposures, [&](double share) {
        Interruption::check();
        if (tell)
            tell(share);
    });
}

CompareResult measured(const CompareOptions& options, const ComparedPictures& compared)
{
    const PicturePair& pair = compared.pair;
    const bool hdr = !compared.displayedReference && !compared.displayedPicture;
    std::unique_ptr<PictureWriter> file;
    if (!options.output.empty())
        file = openDifference(options, pair.width, pair.height, hdr);
    CompareResult result;
    result.width = pair.width;
    result.height = pair.height;
    result.nonfiniteReference = pair.nonfiniteReference;
    result.nonfinitePicture = pair.nonfinitePicture;
    result.linear = linearError(pair);
    // Of the pictures that hold radiance; the others are shown as they are.
    result.display = displayAsked({}, options.exposure, options.curve);
    const PicturePair shown = displayed(pair, compared.displayedReference ? Display{} : result.display,
                                        compared.displayedPicture ? Display{} : result.display);
    const PicturePair sent = encoded(shown);
    result.psnr_db = psnr_db(sent);
    Interruption::check();
    result.ssim = ssim(sent);
    Interruption::check();
    if (hdr)
        result.exposures = flipExposures(pair);
    const std::vector<float> errors = flipErrors(options, compared, shown, result.exposures);
    result.flip = pooled(errors, pair.judged);
    Interruption::check();
    if (file)
        writeDifference(*file, options, pair, errors);
    return result;
}

// What goes with --methods alone, and what it cannot do without.
void refuseOrphans(const CompareOptions& options)
{
    if (options.picture.empty())
        fail(ExitCode::usage, "there is nothing to compare " + options.reference + " with",
             "name a second picture, or --methods for a scene, as in --methods trace,phong:64");
    const CompareOptions usual;
    const bool drawn = options.width != usual.width || options.height != usual.height ||
                       options.samples != usual.samples || options.time_s != usual.time_s ||
                       !options.overrides.empty() || !options.included.empty() ||
                       options.backend != usual.backend || options.wipe || options.difference;
    if (drawn)
        fail(
            ExitCode::usage,
            "--size, --spp, --time, --set, --include, --backend, --wipe and --difference are of a scene that "
            "is drawn, and two pictures are named",
            "leave them out, or name one scene and --methods");
}

} // namespace

ExitCode compare(const CompareOptions& options)
{
    if (comparesMethods(options))
        return compareMethods(options);
    refuseOrphans(options);
    Stopwatch whole;
    refuseBadDifference(options); // before anything is read
    const ComparedPictures compared = readCompared(options);
    CompareResult result;
    if (const int signal = signalDuring([&] { result = measured(options, compared); }); signal != 0) {
        fmt::print(stderr, "dioptre: stopped by a signal, and nothing was written\n");
        endBySignal(signal);
    }
    result.total_ms = whole.lap_ms();
    fmt::print("{}", options.json ? compareJson(options, result) : compareText(options, result));
    return ExitCode::done;
}

} // namespace dioptre
