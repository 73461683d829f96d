// The widget that a row's kind calls for.
#pragma once

#include "live/panel_row.h"

namespace dioptre
{

// As wide as so many pixels; true once `numbers` were changed, which need not fit yet.
bool editNumbers(const PanelRow& row, std::vector<double>& numbers, float width_px);

} // namespace dioptre
