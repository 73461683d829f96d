// The panel: every value that can be changed, and what drawing and reloading take.
#pragma once

#include "live/ui.h"

namespace dioptre
{

void drawPanel(const LiveModel& model, const UiFacts& facts, UiWishes& wishes);

} // namespace dioptre
