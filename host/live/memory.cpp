#include "live/memory.h"

#include "base/file.h"
#include "base/text.h"
#include "base/write_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// https://specifications.freedesktop.org/basedir-spec: a relative folder is not to be used. "" where the user
// has none.
fs::path stateFolder()
{
    const auto folderIn = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value != nullptr ? value : "");
    };
    if (const fs::path state = folderIn("XDG_STATE_HOME"); state.is_absolute())
        return state / "dioptre";
    if (const fs::path home = folderIn("HOME"); home.is_absolute())
        return home / ".local" / "state" / "dioptre";
    return {};
}

// As it stands where its folder is gone.
std::string wholeName(const fs::path& input)
{
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(input, error);
    return (error ? input : whole).string();
}

fs::path fileOf(const fs::path& input)
{
    const fs::path folder = stateFolder();
    return folder.empty() ? folder : folder / fmt::format("{:016x}.json", fingerprint(wholeName(input)));
}

// Of a window that there can be; 0 else.
glm::ivec2 sizeIn(const Json& json)
{
    const auto width_px = json.at("width").get<double>(), height_px = json.at("height").get<double>();
    const auto fits = [](double side_px) { return side_px >= 1.0 && side_px <= 16384.0; };
    return fits(width_px) && fits(height_px) ? glm::ivec2(width_px, height_px) : glm::ivec2(0);
}

Json jsonOf(const Camera& camera)
{
    return {{"eye", {camera.eye.x, camera.eye.y, camera.eye.z}},
            {"target", {camera.target.x, camera.target.y, camera.target.z}},
            {"fov_y_deg", camera.fovY_deg}};
}

Camera cameraIn(const Json& json)
{
    const auto vector = [](const Json& v) {
        return glm::dvec3(v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>());
    };
    Camera camera;
    camera.eye = vector(json.at("eye"));
    camera.target = vector(json.at("target"));
    camera.fovY_deg = json.at("fov_y_deg").get<double>();
    return camera;
}

} // namespace

std::optional<Remembered> recall(const fs::path& input)
{
    const fs::path file = fileOf(input);
    std::error_code ignored;
    if (file.empty() || !fs::is_regular_file(file, ignored))
        return std::nullopt;
    try {
        const Json json = Json::parse(readFile(file));
        Remembered what;
        what.size_px = sizeIn(json);
        what.panel = json.at("panel").get<bool>();
        if (json.contains("camera")) {
            what.hand = cameraIn(json.at("camera"));
            what.own = cameraIn(json.at("own_camera"));
        }
        return what;
    } catch (const Json::exception&) { // of another version, or damaged
        return std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

void remember(const fs::path& input, const Remembered& what)
{
    const fs::path file = fileOf(input);
    if (file.empty())
        return;
    Json json = {{"input", wholeName(input)},
                 {"width", what.size_px.x},
                 {"height", what.size_px.y},
                 {"panel", what.panel}};
    if (what.hand) {
        json["camera"] = jsonOf(*what.hand);
        json["own_camera"] = jsonOf(what.own);
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    writeFile(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace dioptre
