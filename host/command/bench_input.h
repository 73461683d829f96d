// What a user's SCENE@path=value,… or SHADER@uniform=value,… means.
#pragma once

#include "base/search_places.h"
#include "command/method_drawing.h"
#include "gl/context.h"
#include "render/drawing.h"
#include "render/prepare.h"

#include <memory>

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

struct BenchInput {
    std::string name; // as the user wrote it
    std::filesystem::path file;
    std::vector<std::string> overrides; // path=value; of a plain shader uniform=value
    bool plainShader = false;
    Method method{};     // of a scene
    SearchPlaces places; // of its pictures and includes
};

// `method`: where the input says no other by method=NAME among its overrides. Throws usage and inputMissing.
BenchInput readBenchInput(const std::string& text, const SearchPlaces& places, const std::string& method);

// The scene under its overrides. Faults name the input, which must be no plain shader.
Scene sceneOf(const BenchInput& input);

// An input on the current context, with the scene that it may be of.
MethodDrawing drawingOf(const BenchInput& input, const ViewSettings& view, const ContextInfo& context);

} // namespace dioptre
