// From a TOML file to a Scene, or an error that names file, line, column and the mend.
#pragma once

#include "base/search_places.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dioptre
{

// Reads and checks a scene. `overrides` are the "path=value" of --set, applied in order before the checks:
// the path is a table's ("trace.form", "camera.fov_y_deg", "material.glass.ior", "light.0.diffuse",
// "sphere.2.radius") or starts with an object's name ("ball.centre"); the value is TOML, or a bare word taken
// as a string. What [[animate]] changes is as it is at `time_s`, seconds; an override of it is refused.
// `places` are where its pictures may lie besides its own folder. Throws badInput, inputMissing.
Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                double time_s = 0.0, const SearchPlaces& places = {});

// The text of a scene's file. Throws inputMissing, and badInput where it is empty: a file that another
// program did not get to write.
std::string readSceneText(const std::filesystem::path& path);

// The same from text; `path` is for messages and for the folder that picture names are relative to.
Scene parseScene(const std::string& text, const std::filesystem::path& path,
                 const std::vector<std::string>& overrides = {}, double time_s = 0.0,
                 const SearchPlaces& places = {});

// A scene at any time, seconds; throws badInput where a mixture of good keys is no good.
using SceneOverTime = std::function<Scene(double time_s)>;

// As parseScene(), for many times: the text is read and checked once.
SceneOverTime parseSceneOverTime(const std::string& text, const std::filesystem::path& path,
                                 const std::vector<std::string>& overrides = {},
                                 const SearchPlaces& places = {});

} // namespace dioptre
