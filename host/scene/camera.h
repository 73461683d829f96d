// The frame that a camera looks along.
#pragma once

#include "scene/scene.h"

namespace dioptre
{

// Columns: right, up, back (the camera looks along minus the third), of unit length and right-handed. Up is
// as near to +y as it can be, and as near to -z where the camera looks straight along y.
glm::dmat3 worldFromCamera(const Camera& camera);

} // namespace dioptre
