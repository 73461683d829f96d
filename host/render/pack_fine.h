// What kernels that are chosen for precision read of an object: low parts and surface points, in doubles.
#pragma once

#include "kernel/packed_scene.h"
#include "scene/scene.h"

namespace dioptre
{

// Relative to the origin, as packShape().
packed::FineShape packFine(const Primitive& primitive, const glm::dvec3& origin);

} // namespace dioptre
