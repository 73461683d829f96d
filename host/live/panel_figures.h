// The part of the panel that tells what drawing and reloading take.
#pragma once

#include "live/ui_facts.h"

namespace dioptre
{

// What goes on at this moment: compiling, or that there is no picture yet; else what is shown.
void drawState(const LiveModel& model, const UiFacts& facts);

// What the colours of a view mean.
void drawLegend(const UiFacts& facts);

// Times, rays, the plan and the files.
void drawFigures(const LiveModel& model, const UiFacts& facts);

} // namespace dioptre
