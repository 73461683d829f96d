// The part of the panel that changes values.
#pragma once

#include "live/panel.h"

namespace dioptre
{

void drawValues(const LiveModel& model, const Loaded& loaded, const StageFacts& stage, PanelState& state,
                UiWishes& wishes);

} // namespace dioptre
