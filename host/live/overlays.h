// What lies over the picture: that it is stale and why, the keys, and short notices.
#pragma once

#include "live/fault.h"

#include <string>

struct ImFont;

namespace dioptre
{

// Of the window's height, that drawFault() takes.
float faultHeight_px();

// At the bottom; sources in `code`, a font of one width.
void drawFault(const Fault& fault, ImFont* code);

// `left_px`: where the panel ends.
void drawStaleMark(float left_px);
void drawNotice(const std::string& text, float left_px);

void drawHelp();

} // namespace dioptre
