#include "command/compare_input.h"

#include "base/file.h"

#include <fmt/format.h>

#include <cmath>

namespace dioptre
{
namespace
{

// By content, as readPicture() tells them.
bool isDisplayed(const std::string& path)
{
    std::ifstream in = openFile(path);
    std::string start(3, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == "\x89PN" || start == "\xff\xd8\xff";
}

// CLI11's own range lets NaN pass.
void refuseBadNumbers(const CompareOptions& options)
{
    if (!(options.pixelsPerDegree >= 1.0 && options.pixelsPerDegree <= 1000.0))
        fail(ExitCode::usage, fmt::format("--ppd {} is out of reach", options.pixelsPerDegree),
             "give a number of pixels a degree from 1 to 1000");
    if (options.exposure && !(std::abs(*options.exposure) <= 100.0))
        fail(ExitCode::usage, fmt::format("--exposure {} is out of reach", *options.exposure),
             "give a number of stops from -100 to 100");
}

void refuseIdleDisplay(const CompareOptions& options, const ComparedPictures& compared)
{
    if (compared.displayedReference && compared.displayedPicture &&
        (options.exposure || !options.curve.empty()))
        fail(ExitCode::usage,
             fmt::format("{} is for radiance, and both pictures hold what a display is sent",
                         options.exposure ? "--exposure" : "--curve"),
             "leave it out, or compare HDR or EXR pictures");
}

} // namespace

ComparedPictures readCompared(const CompareOptions& options)
{
    refuseBadNumbers(options);
    ComparedPictures compared;
    compared.displayedReference = isDisplayed(options.reference);
    compared.displayedPicture = isDisplayed(options.picture);
    refuseIdleDisplay(options, compared);
    const Picture reference = readPicture(options.reference), picture = readPicture(options.picture);
    if (reference.width != picture.width || reference.height != picture.height)
        fail(ExitCode::badInput, {options.picture},
             fmt::format("is {}x{}, and {} is {}x{}", picture.width, picture.height, options.reference,
                         reference.width, reference.height),
             "compare pictures of one size");
    compared.pair = pairOf(reference, picture);
    return compared;
}

} // namespace dioptre
