// Calls of the kernels, one an object, and what hits on those that are chosen for precision ask besides.
#pragma once

#include "kernel/packed_scene.h"
#include "render/plan.h"

#include <string>

namespace dioptre
{

// A Crossing: "sphereCrossing(ray, 3, vec3(…), 1.0)".
std::string crossingCall(const PackedObject& object, const Plan& plan, std::size_t id);

// A Span of a solid.
std::string spanCall(const PackedObject& object, const Plan& plan, std::size_t id);

// Arguments of its kernel, after the ray and the object.
std::string kernelArguments(const PackedObject& object, const Plan& plan, std::size_t id);

// hasOwnKernel(): which objects those are.
std::string ownKernelText(const PackedScene& packed, const Plan& plan);

// chosenNormal() and chosenPosition(), of glsl/trace/normal.glsl.
std::string chosenSurfaces(const PackedScene& packed, const Plan& plan);

} // namespace dioptre
