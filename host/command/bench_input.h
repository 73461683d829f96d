// What a user's SCENE@path=value,… means.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

struct BenchInput {
    std::string name; // as the user wrote it
    std::filesystem::path scene;
    std::vector<std::string> overrides; // path=value
};

// Throws usage and inputMissing; plain shaders are refused.
BenchInput readBenchInput(const std::string& text);

// The scene under its overrides. Faults name the input.
Scene sceneOf(const BenchInput& input);

} // namespace dioptre
