#include "base/tone_curve.h"
#include "command/compare.h"
#include "command/include_option.h"
#include "command/method_option.h"
#include "command/size_option.h"
#include "gl/context.h"
#include "scene/choices.h"

#include <CLI/CLI.hpp>

namespace dioptre
{

namespace
{

// Of a scene that is drawn by several methods.
void addMethods(CLI::App& command, CompareOptions& options)
{
    command
        .add_option("--methods", options.methods,
                    "draw the scene by these, separated by commas, and hold the others to the first; -o is a "
                    "sheet of them all:" +
                        methodHelp())
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("METHOD,METHOD[:N],...");
    command
        .add_option_function<std::string>(
            "--size", [&options](const std::string& text) { readSize(text, options.width, options.height); },
            "width and height of each picture in pixels")
        ->type_name("WxH")
        ->default_str("480x270");
    command.add_option("--spp", options.samples, "samples a pixel, the same of all methods")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    command.add_option("--time", options.time_s, "the moment of an animated scene, in seconds")
        ->type_name("S")
        ->capture_default_str();
    command.add_option("--set", options.overrides, "change a value of the scene; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    addInclude(command, options.included);
    command.add_option("--backend", options.backend, "where to draw")
        ->check(CLI::IsMember(backendNames()))
        ->capture_default_str();
    command
        .add_option("--wipe", options.wipe,
                    "of two methods: the first left of this share of the width, the second right of it, in "
                    "place of a sheet")
        ->type_name("SHARE");
    command.add_flag("--difference", options.difference,
                     "of two methods: the map of their differences alone, in place of a sheet");
}

} // namespace

void addCompare(CLI::App& app, CompareOptions& options)
{
    auto* command = app.add_subcommand(
        "compare",
        "measure how far a picture is from a reference: RMSE, PSNR, SSIM, FLIP and more; or draw a "
        "scene by several methods, side by side");
    command
        ->add_option("reference", options.reference,
                     "the truth: PNG, JPEG, Radiance HDR or EXR; a scene with --methods")
        ->required()
        ->type_name("REFERENCE|SCENE");
    command->add_option("picture", options.picture, "what is judged; of the same size, of any of these kinds")
        ->type_name("PICTURE");
    command
        ->add_option(
            "-o,--output", options.output,
            "difference picture: .png, FLIP's error from black by magma to pale yellow, green where a "
            "pixel is not finite; or .hdr and .exr, |PICTURE - REFERENCE| of each channel")
        ->type_name("FILE");
    command
        ->add_option("--ppd", options.pixelsPerDegree,
                     "FLIP: pixels a degree of the viewer's field, 1 to 1000; 67 is a display of 3840 pixels "
                     "on 0.7 m seen "
                     "from 0.7 m")
        ->type_name("N")
        ->capture_default_str();
    command
        ->add_option("--exposure", options.exposure,
                     "HDR and EXR: radiance is multiplied by 2^STOPS before it is clamped to what a display "
                     "shows (PSNR, SSIM, LDR-FLIP)")
        ->type_name("STOPS");
    std::vector<std::string> curves;
    for (const auto& row : toneCurves)
        curves.emplace_back(row.name);
    command
        ->add_option("--curve", options.curve,
                     "HDR and EXR: how radiance becomes 0 to 1 after the exposure, as render "
                     "has it; none by default")
        ->check(CLI::IsMember(curves))
        ->type_name("CURVE");
    addMethods(*command, options);
    command->add_flag("--json", options.json, "print figures as JSON");
}

} // namespace dioptre
