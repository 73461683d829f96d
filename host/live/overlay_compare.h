// What lies over two pictures that are held against each other: the divider, and which is which.
#pragma once

#include "live/method_choice.h"

namespace dioptre
{

// `left_px`: where the panel ends. `held`: the divider, by the hand.
void drawComparison(const MethodChoice& choice, bool held, float left_px);

} // namespace dioptre
