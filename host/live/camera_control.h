// Moving a camera by hand: pure functions from one camera to the next.
#pragma once

#include "scene/scene.h"

#include <string>

namespace dioptre
{

// Around its target: right and up by radians, as the scene is dragged. Short of the poles.
Camera orbited(Camera camera, double right_rad, double up_rad);

// The head turned: the target goes round the eye.
Camera turned(Camera camera, double right_rad, double up_rad);

// Both eye and target, in the picture's plane: in its heights at the target's distance.
Camera panned(Camera camera, double right, double up);

// Both, along the camera's own right, the world's up, and ahead; metres.
Camera flown(Camera camera, const glm::dvec3& rightUpAhead_m);

// The field of view wider or narrower, by notches of a wheel; 1 to 170 degrees.
Camera zoomed(Camera camera, double notches);

// To the digits that are written: a camera that is written and read is the same.
Camera rounded(Camera camera);

// As it stands in a scene's file: "[camera]\neye = [...]\n".
std::string tomlOf(const Camera& camera);

// As --set takes it: "camera.eye=[...]" and so on.
std::vector<std::string> overridesOf(const Camera& camera);

} // namespace dioptre
