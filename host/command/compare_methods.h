// `dioptre compare SCENE --methods …`: one scene by several methods, side by side, with what each costs and
// how far it is from the first.
#pragma once

#include "command/compare.h"
#include "gl/context.h"
#include "metric/linear_error.h"
#include "raster/method.h"
#include "render/drawing.h"

#include <vector>

namespace dioptre
{

// What was found of one method.
struct MethodRow {
    Method method;
    Picture picture;              // radiance
    std::vector<double> frame_ms; // of each round
    BuildTimes built;
    DrawingFacts facts;
    std::size_t nonfinite = 0; // pixels
    LinearError linear;        // from the first method's picture; of that itself 0
    double ssim = 1.0;
    std::vector<float> differences; // of each pixel the largest of its channels', rows from the bottom up
};

struct MethodsResult {
    std::string scene; // as its file has it; its name without
    ContextInfo context;
    Display display;
    std::vector<MethodRow> rows;
    double scale = 0.0; // the difference that is shown brightest, radiance
};

// Whether the options ask for it.
inline bool comparesMethods(const CompareOptions& options)
{
    return !options.methods.empty();
}

// Draws, measures, and writes what the options ask for. Throws usage, inputMissing, badInput, cannotWrite.
ExitCode compareMethods(const CompareOptions& options);

std::string methodsText(const CompareOptions& options, const MethodsResult& result);
std::string methodsJson(const CompareOptions& options, const MethodsResult& result);

// The sheet, the wipe or the map of differences that the options ask for, srgb8.
Picture methodsPicture(const CompareOptions& options, const MethodsResult& result);

} // namespace dioptre
