// `dioptre compare`: how far one picture is from another, by every metric of use, and where.
#pragma once

#include "base/error.h"
#include "metric/flip.h"

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace dioptre
{

struct CompareOptions {
    std::string reference; // the truth: PNG, JPEG, Radiance HDR or EXR
    std::string picture;   // what is judged, of any of these kinds and of the same size
    std::string output;    // difference picture, .png, .hdr or .exr; "" for none
    double pixelsPerDegree = usualPixelsPerDegree; // of the viewer's field, 1 to 1000
    std::optional<double> exposure;                // stops, of what holds radiance; 0 where unset
    std::string curve;                             // of toneCurves, of what holds radiance; "" for none
    bool json = false;
};

// Adds the command; parsing fills `options`, which must live that long.
void addCompare(CLI::App& app, CompareOptions& options);

// Prints the figures. Gives done however large they are; throws usage, inputMissing, badInput, cannotWrite.
ExitCode compare(const CompareOptions& options);

} // namespace dioptre
