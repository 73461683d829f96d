// What all pixels share, sent through the vertex stage as flat values in place of uniforms read by each
// pixel.
#pragma once

#include "kernel/packed_scene.h"
#include "render/plan.h"

#include <string>
#include <vector>

namespace dioptre
{

// What the plan's shader reads of the camera, the sky and the settings; of lights; of materials, those first
// that weigh most.
std::vector<SharedValue> sharedView(const Plan& plan);
std::vector<SharedValue> sharedMaterials(const Scene& scene, const Plan& plan);
std::vector<SharedValue> sharedLights(const Scene& scene, const Plan& plan);

// How many vec4 they take.
int vectorsOf(const std::vector<SharedValue>& values);

// The vertex stage's outputs and the statements that fill them; receiveShared() for the fragment stage.
std::string shareDeclaration(const std::vector<SharedValue>& values);
std::string shareStatements(const std::vector<SharedValue>& values);
std::string receiveText(const std::vector<SharedValue>& values);

} // namespace dioptre
