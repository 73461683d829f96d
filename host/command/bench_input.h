// What a user's SCENE@path=value,… or SHADER@uniform=value,… means.
#pragma once

#include "base/search_places.h"
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
    SearchPlaces places; // of its pictures and includes
};

// Throws usage and inputMissing.
BenchInput readBenchInput(const std::string& text, const SearchPlaces& places);

// The scene under its overrides. Faults name the input, which must be no plain shader.
Scene sceneOf(const BenchInput& input);

// An input on the current context, with the scene that it may be of.
struct BenchDrawing {
    std::unique_ptr<PreparedScene> prepared; // none for a plain shader; outlives the drawing
    std::unique_ptr<Drawing> drawing;
};
BenchDrawing drawingOf(const BenchInput& input, const ViewSettings& view, const ContextInfo& context);

} // namespace dioptre
