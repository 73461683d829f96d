// `dioptre compare`: how far one picture is from another, by every metric of use, and where.
#pragma once

#include "base/error.h"
#include "metric/flip.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace dioptre
{

struct CompareOptions {
    std::string reference; // the truth: PNG, JPEG, Radiance HDR or EXR; with methods a scene
    std::string picture;   // what is judged, of any of these kinds and of the same size
    std::string output;    // difference picture, .png, .hdr or .exr; of methods a .png; "" for none
    double pixelsPerDegree = usualPixelsPerDegree; // of the viewer's field, 1 to 1000
    std::optional<double> exposure;                // stops, of what holds radiance; 0 where unset
    std::string curve;                             // of toneCurves, of what holds radiance; "" for none
    bool json = false;

    // Of a scene by several methods:
    std::vector<std::string> methods; // as methodNamed() reads them; the first is what the others are held to
    int width = 480;                  // pixels
    int height = 270;                 // pixels
    int samples = 4;                  // a pixel
    double time_s = 0.0;              // of an animated scene
    std::vector<std::string> overrides; // path=value
    std::vector<std::string> included;  // folders that the scene may take files from
    std::string backend = "auto";
    std::optional<double> wipe; // where the second method's picture begins, 0..1, in place of a sheet
    bool difference = false;    // the map of their differences in place of a sheet
};

// Adds the command; parsing fills `options`, which must live that long.
void addCompare(CLI::App& app, CompareOptions& options);

// Prints the figures. Gives done however large they are; throws usage, inputMissing, badInput, cannotWrite.
ExitCode compare(const CompareOptions& options);

} // namespace dioptre
