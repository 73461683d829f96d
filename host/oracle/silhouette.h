// How near a line passes to what bounds a primitive as seen along it.
#pragma once

#include "oracle/crossing.h"

namespace dioptre
{

// Metres, as RayAnswer::margin says; `line` starts relative to the reference point. The distances of the line
// are taken in quad, where digits cancel, and combined in double: good to 1e-14 of the distance to the shape
// plus its size.
double distanceToBounds(const QuadShape& shape, const QuadRay& line);

// From the point (x, y) to the ellipse with these half axes along x and y, either of which may be 0.
double distanceToEllipse(double halfX, double halfY, double x, double y);

} // namespace dioptre
