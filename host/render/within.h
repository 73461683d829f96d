// Whether the eye is within a closed solid: what is met from outside alone needs less of a kernel.
#pragma once

#include "scene/scene.h"

namespace dioptre
{

// Whether a shape has an inside: a sphere or a capped cylinder.
bool isSolid(const Primitive& primitive);

// Well outside, for floats too: by a millionth of what the distance is made of.
bool isOutside(const Primitive& solid, const glm::dvec3& eye);

} // namespace dioptre
