#include "command/write_still.h"

#include "base/text.h"
#include "command/video.h"
#include "render/layers.h"
#include "scene/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace dioptre
{
namespace
{

enum class PictureKind {
    png,      // for the eye
    radiance, // .hdr: linear radiance
    exr       // linear radiance or a view's data
};

PictureKind kindOf(const std::string& output)
{
    const auto extension = std::filesystem::path(output).extension();
    if (extension == ".png")
        return PictureKind::png;
    if (extension == ".hdr")
        return PictureKind::radiance;
    if (extension == ".exr")
        return PictureKind::exr;
    fail(ExitCode::usage, "-o " + output + " is none of .png, .hdr and .exr",
         "name the picture FILE.png, FILE.hdr or FILE.exr");
}

// The options given that turn radiance into what a display is sent, for messages; "" where there is none.
std::string displayOptions(const RenderOptions& options)
{
    std::vector<std::string> given;
    if (options.exposure)
        given.emplace_back("--exposure");
    if (!options.curve.empty())
        given.emplace_back("--curve");
    if (!options.gamma.empty())
        given.emplace_back("--gamma");
    return join(given, " and ");
}

std::optional<double> gammaNamed(const std::string& text)
{
    if (text.empty() || text == "srgb")
        return {};
    double gamma = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, gamma);
    if (fault != std::errc{} || stop != end || !(gamma >= 0.1 && gamma <= 10.0))
        fail(ExitCode::usage, "--gamma " + text + " is no encoding", "give srgb or a number from 0.1 to 10");
    return gamma;
}

void refuseBadDisplay(const RenderOptions& options, PictureKind kind, bool plainShader)
{
    const std::string given = displayOptions(options);
    if (!given.empty() && kind != PictureKind::png)
        fail(ExitCode::usage, given + " is for PNG, and " + options.output + " holds linear radiance",
             "leave it out, or name the picture FILE.png");
    if (!given.empty() && plainShader)
        fail(ExitCode::usage,
             options.input + " is a plain shader, whose colours go unchanged, and " + given +
                 " is for scenes",
             "leave it out");
    if (!given.empty() && !options.view.empty())
        fail(ExitCode::usage, "--view " + options.view + " shows data, and " + given + " is for light",
             "leave one of them out");
    if (options.exposure && !(std::abs(*options.exposure) <= 100.0))
        fail(ExitCode::usage, fmt::format("--exposure {} is out of reach", *options.exposure),
             "give a number of stops from -100 to 100");
    gammaNamed(options.gamma);
}

void refuseBadLayers(const RenderOptions& options, PictureKind kind, bool plainShader)
{
    layersNamed(options.layers);
    if (options.layers.empty())
        return;
    if (kind != PictureKind::exr)
        fail(ExitCode::usage, "--layers is for EXR, and " + options.output + " is none",
             "name the picture FILE.exr");
    if (plainShader)
        fail(ExitCode::usage, options.input + " is a plain shader, and --layers is for scenes",
             "leave it out");
    if (options.reference || !options.view.empty())
        fail(ExitCode::usage,
             std::string("--layers stands beside light that a shader draws, and ") +
                 (options.reference ? "--reference has no shader" : "--view asks for data in its place"),
             "leave one of them out");
}

void addView(Settings& settings, const RenderOptions& options, const ShownView& shown)
{
    settings["dioptre.view"] = options.view;
    settings["dioptre.legend"] = join(shown.legend.lines, "\n");
}

// Only what differs from radiance 1 as white and sRGB.
void addDisplay(Settings& settings, const Display& display)
{
    if (display.exposure != 0.0)
        settings["dioptre.exposure"] = fmt::format("{}", display.exposure);
    for (const auto& curve : toneCurves)
        if (curve.choice == display.curve && display.curve != ToneCurve::none)
            settings["dioptre.curve"] = curve.name;
    if (display.gamma)
        settings["dioptre.gamma"] = fmt::format("{}", *display.gamma);
}

// Hands the numbers of a PNG to `take`, with the form that they are to be given.
template <typename Take>
auto display(const StillContent& content, int bits, Take take)
{
    PngForm form{.encode = false, .gamma = {}, .bits = bits};
    if (content.shown != nullptr)
        return take(content.shown->picture, form);
    if (content.display == nullptr)
        return take(content.still.picture, form);
    form.encode = true;
    form.gamma = content.display->gamma;
    if (content.display->exposure == 0.0 && content.display->curve == ToneCurve::none)
        return take(content.still.picture, form); // spares a copy
    return take(toned(content.still.picture, *content.display), form);
}

void writeDisplayed(const RenderOptions& options, const StillContent& content, Settings settings)
{
    if (content.shown == nullptr && content.display != nullptr)
        addDisplay(settings, *content.display);
    display(content, options.bits == 16 ? 16 : 8, [&](const Picture& picture, const PngForm& form) {
        writePng(options.output, picture, form, settings);
    });
}

} // namespace

void refuseBadOutput(const RenderOptions& options, bool plainShader)
{
    const bool video = !options.frames.empty() && isVideo(options.output);
    const PictureKind kind = video ? PictureKind::png : kindOf(options.output); // both for the eye
    if (options.half && kind != PictureKind::exr)
        fail(ExitCode::usage, "--half is for EXR, and " + options.output + " is none",
             "name the picture FILE.exr");
    if (options.bits != 0 && (video || kind != PictureKind::png))
        fail(ExitCode::usage, "--depth is for PNG, and " + options.output + " is none",
             "leave it out, or name the picture FILE.png");
    refuseBadDisplay(options, kind, plainShader);
    refuseBadLayers(options, kind, plainShader);
}

Display displayOf(const RenderOptions& options, const Display& scene)
{
    Display display = scene;
    display.exposure = options.exposure.value_or(scene.exposure);
    for (const auto& curve : toneCurves)
        if (options.curve == curve.name)
            display.curve = curve.choice;
    if (!options.gamma.empty())
        display.gamma = gammaNamed(options.gamma);
    return display;
}

Settings settingsOf(const RenderOptions& options, const ContextInfo& context)
{
    Settings settings = {{"Software", std::string("dioptre ") + DIOPTRE_VERSION},
                         {"dioptre.input", options.input},
                         {"dioptre.size", fmt::format("{}x{}", options.width, options.height)},
                         {"dioptre.spp", std::to_string(options.samples)},
                         {"dioptre.time", fmt::format("{}", options.time_s)},
                         {"dioptre.backend", context.backend},
                         {"dioptre.renderer", context.renderer}};
    if (!options.overrides.empty())
        settings["dioptre.set"] = join(options.overrides, " ");
    if (!options.layers.empty())
        settings["dioptre.layers"] = join(options.layers, ",");
    if (!options.settingsHash.empty())
        settings["dioptre.hash"] = options.settingsHash;
    return settings;
}

std::vector<std::uint8_t> displayedBytes(const StillContent& content)
{
    return display(content, 8,
                   [](const Picture& picture, const PngForm& form) { return topDownBytes(picture, form); });
}

void writeStill(const RenderOptions& options, const StillContent& content)
{
    Settings settings = settingsOf(options, content.context);
    if (content.shown != nullptr)
        addView(settings, options, *content.shown);
    switch (kindOf(options.output)) {
    case PictureKind::png:
        return writeDisplayed(options, content, settings);
    case PictureKind::radiance:
        return writeRadiance(options.output, content.still.picture, settings);
    case PictureKind::exr:
        return writeExr(options.output, content.still.picture, options.half ? ExrDepth::half : ExrDepth::full,
                        settings, content.layers);
    }
}

} // namespace dioptre
