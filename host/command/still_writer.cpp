#include "command/still_writer.h"
#include "command/display_option.h"

#include "base/picture_stack.h"
#include "base/text.h"
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

StoredKind kindOf(const std::string& output)
{
    const auto kind = storedKindNamed(output);
    if (!kind)
        fail(ExitCode::usage, "-o " + output + " is none of .png, .hdr and .exr",
             "name the picture FILE.png, FILE.hdr or FILE.exr");
    return *kind;
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

void refuseBadDisplay(const RenderOptions& options, StoredKind kind, bool plainShader)
{
    const std::string given = displayOptions(options);
    if (!given.empty() && kind != StoredKind::png)
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

void refuseBadLayers(const RenderOptions& options, StoredKind kind, bool plainShader)
{
    layersNamed(options.layers);
    if (options.layers.empty())
        return;
    if (kind != StoredKind::exr)
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

void addView(Settings& settings, const RenderOptions& options, const ViewLegend* legend)
{
    settings["dioptre.view"] = options.view;
    if (legend != nullptr)
        settings["dioptre.legend"] = join(legend->lines, "\n");
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

// How numbers become what a display is sent.
PngForm pngFormOf(const StillForm& form, int bits)
{
    PngForm png{.encode = false, .gamma = {}, .bits = bits};
    if (form.isShownView || !form.display)
        return png;
    png.encode = true;
    png.gamma = form.display->gamma;
    return png;
}

// Hands what a display is to be sent to `take`, unencoded.
template <typename Take>
void displayed(const Picture& band, const StillForm& form, Take take)
{
    const bool plain = form.isShownView || !form.display ||
                       (form.display->exposure == 0.0 && form.display->curve == ToneCurve::none);
    if (plain)
        take(band); // spares a copy
    else
        take(toned(band, *form.display));
}

class StillFile final : public StillWriter
{
public:
    StillFile(const RenderOptions& options, const StillForm& form, int height)
        : form_(form), kind_(kindOf(options.output))
    {
        Settings settings = settingsOf(options, form.context);
        if (!options.view.empty())
            addView(settings, options, form.legend);
        const PngForm png = pngFormOf(form, options.bits == 16 ? 16 : 8);
        if (kind_ == StoredKind::png && png.encode)
            addDisplay(settings, *form.display);
        if (kind_ == StoredKind::png)
            file_ = openPng(options.output, options.width, height, png, settings);
        else if (kind_ == StoredKind::radiance)
            file_ = openRadiance(options.output, options.width, height, settings);
        else
            file_ = openExr(options.output, options.width, height,
                            options.half ? ExrDepth::half : ExrDepth::full, settings, form.layers);
    }

    void add(const Picture& band, const std::vector<ExrLayer>& layers) override
    {
        if (kind_ == StoredKind::png)
            displayed(band, form_, [this](const Picture& picture) { file_->add(picture); });
        else
            file_->add(band, layers);
    }

    void finish() override
    {
        file_->finish();
    }

private:
    StillForm form_;
    StoredKind kind_;
    std::unique_ptr<PictureWriter> file_;
};

class VideoFrame final : public StillWriter
{
public:
    VideoFrame(Video& video, const StillForm& form) : video_(video), form_(form) {}

    void add(const Picture& band, const std::vector<ExrLayer>&) override
    {
        displayed(band, form_,
                  [this](const Picture& picture) { video_.add(topDownBytes(picture, pngFormOf(form_, 8))); });
    }

    void finish() override {}

private:
    Video& video_;
    StillForm form_;
};

} // namespace

void refuseBadOutput(const RenderOptions& options, bool plainShader)
{
    const bool video = !options.frames.empty() && isVideo(options.output);
    const StoredKind kind = video ? StoredKind::png : kindOf(options.output); // both for the eye
    if (options.half && kind != StoredKind::exr)
        fail(ExitCode::usage, "--half is for EXR, and " + options.output + " is none",
             "name the picture FILE.exr");
    if (options.bits != 0 && (video || kind != StoredKind::png))
        fail(ExitCode::usage, "--depth is for PNG, and " + options.output + " is none",
             "leave it out, or name the picture FILE.png");
    refuseBadDisplay(options, kind, plainShader);
    refuseBadLayers(options, kind, plainShader);
}

Display displayOf(const RenderOptions& options, const Display& scene)
{
    Display display = displayAsked(scene, options.exposure, options.curve);
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
    if (!options.included.empty())
        settings["dioptre.include"] = join(options.included, " ");
    if (options.method != "trace")
        settings["dioptre.method"] = options.method;
    if (!options.layers.empty())
        settings["dioptre.layers"] = join(options.layers, ",");
    if (!options.tile.empty())
        settings["dioptre.tile"] = options.tile;
    if (!options.settingsHash.empty())
        settings["dioptre.hash"] = options.settingsHash;
    return settings;
}

std::unique_ptr<StillWriter> openStill(const RenderOptions& options, const StillForm& form, int height)
{
    return std::make_unique<StillFile>(options, form, height);
}

std::unique_ptr<StillWriter> openFrame(Video& video, const StillForm& form)
{
    return std::make_unique<VideoFrame>(video, form);
}

} // namespace dioptre
