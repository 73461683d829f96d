// What a texture unit does, in double precision: the rules of the OpenGL 3.3 specification, section 3.8.11.
#pragma once

#include "base/picture.h"

#include <glm/glm.hpp>

#include <vector>

namespace dioptre
{

enum class Wrap { both, uOnly }; // which coordinates repeat; the others clamp to the edge

// Linear RGBA at uv, bilinear; v = 1 is the picture's top.
glm::dvec4 sampleBilinear(const Picture& picture, glm::dvec2 uv, Wrap wrap);

// The same between the two nearest levels of a mip chain, repeating both ways.
glm::dvec4 sampleTrilinear(const std::vector<Picture>& levels, glm::dvec2 uv, double level);

} // namespace dioptre
