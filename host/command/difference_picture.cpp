#include "command/difference_picture.h"

#include "base/picture_stack.h"
#include "base/srgb.h"
#include "metric/magma.h"

#include <fmt/format.h>

#include <limits>

namespace dioptre
{
namespace
{

Picture flipPicture(const PicturePair& pair, const std::vector<float>& errors)
{
    Picture picture{pair.width, pair.height, PixelFormat::srgb8, {}, {}};
    picture.bytes.reserve(4 * errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const glm::dvec3 green(0.0, 1.0, 0.0); // not in magma
        const glm::vec3 colour = pair.judged[i] != 0 ? magma(static_cast<double>(errors[i])) : green;
        for (const float channel : {colour.r, colour.g, colour.b, 1.0f})
            picture.bytes.push_back(byteFromUnit(channel));
    }
    return picture;
}

Picture radiancePicture(const PicturePair& pair)
{
    Picture picture = blankFloats(pair.width, pair.height);
    for (std::size_t i = 0; i < pair.judged.size(); ++i) {
        const glm::vec3 difference = pair.judged[i] != 0 ? glm::abs(pair.picture[i] - pair.reference[i])
                                                         : glm::vec3(std::numeric_limits<float>::quiet_NaN());
        for (std::size_t channel = 0; channel < 3; ++channel)
            picture.floats[4 * i + channel] = difference[static_cast<int>(channel)];
        picture.floats[4 * i + 3] = 1.0f;
    }
    return picture;
}

} // namespace

void refuseBadDifference(const CompareOptions& options)
{
    if (options.output.empty())
        return;
    if (!storedKindNamed(options.output))
        fail(ExitCode::usage, "-o " + options.output + " is none of .png, .hdr and .exr",
             "name the picture FILE.png, FILE.hdr or FILE.exr");
    for (const auto& input : {options.reference, options.picture}) {
        std::error_code ignored;
        if (input == options.output || std::filesystem::equivalent(input, options.output, ignored))
            fail(ExitCode::usage, "-o " + options.output + " is one of the pictures compared",
                 "name another file with -o");
    }
}

std::unique_ptr<PictureWriter> openDifference(const CompareOptions& options, int width, int height, bool hdr)
{
    const auto kind = storedKindNamed(options.output);
    Settings settings = {{"Software", std::string("dioptre ") + DIOPTRE_VERSION},
                         {"dioptre.reference", options.reference},
                         {"dioptre.picture", options.picture},
                         {"dioptre.shows", "|picture - reference|"}};
    if (kind == StoredKind::radiance)
        return openRadiance(options.output, width, height, settings);
    if (kind == StoredKind::exr)
        return openExr(options.output, width, height, ExrDepth::full, settings);
    settings["dioptre.shows"] =
        fmt::format("{}-FLIP at {} pixels a degree, 0 to 1 in magma; green: not finite", hdr ? "HDR" : "LDR",
                    options.pixelsPerDegree);
    return openPng(options.output, width, height, {.encode = false}, settings);
}

void writeDifference(PictureWriter& file, const CompareOptions& options, const PicturePair& pair,
                     const std::vector<float>& errors)
{
    file.add(storedKindNamed(options.output) == StoredKind::png ? flipPicture(pair, errors)
                                                                : radiancePicture(pair));
    file.finish();
}

} // namespace dioptre
