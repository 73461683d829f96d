// The rows of the methods that a scene is drawn by.
#pragma once

#include "live/method_choice.h"
#include "live/panel_row.h"

namespace dioptre
{

// What plays no part, as the scale of a difference that is not shown, has no row.
std::vector<PanelRow> methodRows(const MethodChoice& choice);

// The choice with another value of one of its rows.
MethodChoice withMethod(MethodChoice choice, const PanelRow& row, const std::vector<double>& numbers);

} // namespace dioptre
