// What lies over the picture: that it is stale and why, the keys, and short notices.
#pragma once

#include "live/ui.h"

namespace dioptre
{

void drawFault(const Fault& fault);
void drawStaleMark();
void drawHelp();
void drawNotice(const std::string& text);

} // namespace dioptre
