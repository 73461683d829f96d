// The sections of a scene file, each read from the document into its part of the Scene.
#pragma once

#include "base/search_places.h"
#include "scene/document.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

// `document` is the whole file as a table; `pictures` says where picture names lead. All throw badInput.
Camera readCamera(const Table& document, const std::vector<Material>& materials);
Sky readSky(const Table& document, const Search& pictures);
Trace readTrace(const Table& document);
PlanChoices readPlan(const Table& document);
Raster readRaster(const Table& document);
Display readOutput(const Table& document);
std::vector<Material> readMaterials(const Table& document, const Search& pictures);
std::vector<Light> readLights(const Table& document);

// Appends the material "default" where an object names none and the scene defines none of that name.
std::vector<Object> readObjects(const Table& document, std::vector<Material>& materials);

// The whole document as a scene, without regard to its animations; `path` is the file's. Throws badInput.
Scene readScene(const Value& document, const std::filesystem::path& path, const SearchPlaces& places);

// The names of the keys that hold arrays of objects: "sphere", "cylinder" and so on.
const std::vector<std::string>& objectKinds();

// The keys of a scene's outermost table.
const std::vector<std::string>& sceneKeys();

// Index of the material that a value names. Throws badInput with a "did you mean".
std::size_t materialIndex(const Value& value, std::string_view key, const std::vector<Material>& materials);

// The elements of an array of tables; none where the key is unset. Throws badInput for [key] in place of
// [[key]].
std::vector<const Value*> tablesUnder(const Table& document, std::string_view key);

// Where the names of pictures in a scene lead: beside it, to the folders of --include, to the gallery's
// pictures.
Search pictureSearch(const std::filesystem::path& scene, const SearchPlaces& places);

// The file that `value` names, a string or a list of which the first that exists is taken. A name that --set
// gives is the user's own and may lead anywhere. Throws badInput, for names that lead elsewhere too, and
// inputMissing.
std::string pictureFile(const Value& value, std::string_view key, const Search& search);

} // namespace dioptre
