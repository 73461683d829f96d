#include "base/tone_curve.h"
#include "command/compare.h"
#include "scene/choices.h"

#include <CLI/CLI.hpp>

namespace dioptre
{

void addCompare(CLI::App& app, CompareOptions& options)
{
    auto* command = app.add_subcommand(
        "compare", "measure how far a picture is from a reference: RMSE, PSNR, SSIM, FLIP and more");
    command->add_option("reference", options.reference, "the truth: PNG, JPEG, Radiance HDR or EXR")
        ->required()
        ->type_name("REFERENCE");
    command->add_option("picture", options.picture, "what is judged; of the same size, of any of these kinds")
        ->required()
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
    command->add_flag("--json", options.json, "print figures as JSON");
}

} // namespace dioptre
