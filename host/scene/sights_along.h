// What an animation shows in its course.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace dioptre
{

// The sights at an animation's keys, of which there is one at least, in the order of time, and seven on the
// way from each to the next, where the eye may come nearer to something than at both: straight, whatever the
// easing.
std::vector<Sight> sightsAlong(const std::vector<Sight>& keys);

} // namespace dioptre
