// Which objects the camera cannot see, found before anything of them is drawn.
#pragma once

#include "kernel/packed_scene.h"

#include <vector>

namespace dioptre
{

// By object, whether any of it may lie in the view of `width` x `height` pixels, half a pixel around it
// included: samples lie beside the pixels' centres. `endless`: planes have no end, and are always seen.
std::vector<bool> seenBy(const PackedScene& scene, int width, int height, bool endless);

// Which sides of an object face an eye.
struct SeenSides {
    bool outer = false; // or front
    bool inner = false; // or back
};
SeenSides sidesSeenFrom(const PackedObject& object, const glm::dvec3& eye);

} // namespace dioptre
