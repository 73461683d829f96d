// The rows of how a picture is shown: they change no scene, but the display that the window shows it by.
#pragma once

#include "base/tone_curve.h"
#include "live/panel_row.h"

namespace dioptre
{

// A power in place of the sRGB curve is in two rows: whether, and which.
std::vector<PanelRow> outputRows(const Display& display);

// The display with another value of one of its rows; with that of another display.
Display withOutput(Display display, const PanelRow& row, const std::vector<double>& numbers);
Display withOutputOf(const Display& other, const PanelRow& row, Display display);

bool differs(const Display& a, const Display& b, const PanelRow& row);

// What of a display differs from another, as --set takes it.
std::vector<std::string> overridesOf(const Display& display, const Display& other);

} // namespace dioptre
