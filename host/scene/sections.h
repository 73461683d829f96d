// The sections of a scene file, each read from the document into its part of the Scene.
#pragma once

#include "scene/document.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

// `document` is the whole file as a table; `folder` the one that picture names are relative to. All throw
// badInput.
Camera readCamera(const Table& document, const std::vector<Material>& materials);
Sky readSky(const Table& document, const std::filesystem::path& folder);
Trace readTrace(const Table& document);
PlanChoices readPlan(const Table& document);
Display readOutput(const Table& document);
std::vector<Material> readMaterials(const Table& document, const std::filesystem::path& folder);
std::vector<Light> readLights(const Table& document);

// Appends the material "default" where an object names none and the scene defines none of that name.
std::vector<Object> readObjects(const Table& document, std::vector<Material>& materials);

// The whole document as a scene, without regard to its animations; `path` is the file's. Throws badInput.
Scene readScene(const Value& document, const std::filesystem::path& path);

// The names of the keys that hold arrays of objects: "sphere", "cylinder" and so on.
const std::vector<std::string>& objectKinds();

// The keys of a scene's outermost table.
const std::vector<std::string>& sceneKeys();

// Index of the material that a value names. Throws badInput with a "did you mean".
std::size_t materialIndex(const Value& value, std::string_view key, const std::vector<Material>& materials);

// The elements of an array of tables; none where the key is unset. Throws badInput for [key] in place of
// [[key]].
std::vector<const Value*> tablesUnder(const Table& document, std::string_view key);

// The file that `value` names, a string or a list of which the first that exists is taken: beside the scene,
// or, for a bare name, in the gallery's textures folder. Throws badInput, inputMissing.
std::string pictureFile(const Value& value, std::string_view key, const std::filesystem::path& folder);

} // namespace dioptre
