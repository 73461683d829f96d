// How far shapes reach, for culling and for what a shadow map must hold.
#pragma once

#include "kernel/packed_scene.h"

namespace dioptre
{

struct Extent {
    double low = 0.0;
    double high = 0.0;
};

// Of dot(place, direction) over all places of the shape, in the scene frame; a plane's is that of its patch,
// of anchor.w metres from its middle to its sides. `direction` may have any length.
Extent extentAlong(const PackedObject& object, const glm::dvec3& direction);

} // namespace dioptre
