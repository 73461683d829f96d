// What a scene needs of a rasterised method, from what it needs of the tracer.
#pragma once

#include "raster/method.h"
#include "render/prepare.h"

namespace dioptre
{

// The plan of the scene as a table, less what only rays need, with rows of what rasterising takes instead.
Plan rasterPlan(const PreparedScene& prepared, const Method& method);

// Whether there are shadow maps.
bool castsShadows(const Plan& plan);

// Lights that reach a pixel one by one, each with a shadow of its own, where facets or vertices are lit; else
// 1: their sum.
int litParts(const Plan& plan);

} // namespace dioptre
