// Which formulation of its kernel an object takes: plain, unless rounding would show.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace dioptre
{

enum class KernelForm {
    plain,
    compensated, // error-free transformations (glsl/kernel/fine_crossing.glsl)
    curved       // from a surface point and 1 / radius (glsl/kernel/curved_crossing.glsl); round shapes alone
};

struct KernelChoice {
    KernelForm form = KernelForm::plain;
    double rounding_px = 0.0; // what the plain kernel may be off by, in pixels of a picture of 1080 lines
};

// Metres from a point to the nearest of the surface, from whatever side.
double distanceTo(const Primitive& primitive, const glm::dvec3& point);

// A plain kernel is off by at most 8 units of rounding of |o - r| + s, with r and s the shape's reference
// point and size. No path to the shape is shorter than the eye's distance e to it, nor than its own last leg,
// so that |o - r| is at most |eye - r| + 2 e on the way of any path whose pixel spans e times a pixel's angle
// there: above a twentieth of a pixel the kernel is compensated. Round shapes of more than 1e4 e go by
// curvature.
KernelChoice chooseKernel(const Primitive& primitive, const Camera& camera);

// By object, the finest that its camera or one of its sights asks for; all plain under plan.kernels =
// "plain".
std::vector<KernelChoice> chooseKernels(const Scene& scene);

// Adds those sights to the scene's for which some object wants a finer kernel than for all before.
void addSights(Scene& scene, const std::vector<Sight>& sights);

} // namespace dioptre
