// What --why and --json say of a picture.
#pragma once

#include "command/command.h"
#include "command/draw_picture.h"

#include <string>

namespace dioptre
{

struct StillReport {
    PictureFigures figures;
    DrawingFacts facts;
    Phases phases;                     // of making and drawing
    std::optional<double> beyondTrust; // share of a scene's picture, as shareBeyondTrust()
};

// The sums of two, but for the total.
Phases together(const Phases& a, const Phases& b);

// The plan's table, what the shader holds, and its compile times. A plain shader has no plan.
std::string whyText(const Plan* plan, const StillReport& still);

// The shader as a file of its own: its part's plan as its head comment, then the text that the driver got. A
// plain shader has no part.
std::string shaderText(const DrawnPart* part, const SourceText& shader);

// One JSON object; see the README for its keys.
std::string jsonText(const RenderOptions& options, const StillReport& still, const ContextInfo& context,
                     const Plan* plan);

} // namespace dioptre
