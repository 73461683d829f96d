// Scenes nobody would write: every kind of shape, material, light, sky and tree, mixed at random.
#pragma once

#include <string>

namespace dioptre::test
{

// The text of a scene file; the same for the same seed.
std::string randomScene(unsigned seed);

} // namespace dioptre::test
