// What kernels that are chosen for precision read of an object: low parts and surface points, in doubles.
#pragma once

#include "kernel/packed_scene.h"

namespace dioptre
{

// Of what packShape() made.
packed::FineShape packFine(const PackedObject& object);

} // namespace dioptre
