// What --why and --json say of a picture.
#pragma once

#include "command/command.h"
#include "render/still.h"
#include "render/view_picture.h"

#include <string>

namespace dioptre
{

// The plan's table, what the shader holds, and its compile times. A plain shader has no plan.
std::string whyText(const Plan* plan, const Still& still);

// The shader as a file of its own: its part's plan as its head comment, then the text that the driver got. A
// plain shader has no part.
std::string shaderText(const DrawnPart* part, const SourceText& shader);

// One JSON object; see the README for its keys. `legend`: of a view, else null.
std::string jsonText(const RenderOptions& options, const Still& still, const ContextInfo& context,
                     const Plan* plan, const ViewLegend* legend);

} // namespace dioptre
