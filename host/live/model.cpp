#include "live/model.h"

#include "live/panel_row.h"

#include <algorithm>

namespace dioptre
{

std::vector<double> sliderOf(const LiveModel& model, const Loaded& loaded, const std::string& name,
                             const std::vector<double>& none)
{
    const LiveValues& live = model.frame.live;
    if (name == "u_light_type" && live.lightType)
        return {static_cast<double>(*live.lightType)};
    if (name == "u_light_height" && live.lightHeight_m)
        return {*live.lightHeight_m};
    for (const HostNumbers* numbers : {&live.sliders, &loaded.sliders})
        if (const auto found = numbers->find(name);
            found != numbers->end() && found->second.size() == none.size())
            return found->second;
    return none;
}

Camera cameraOf(const LiveModel& model, const Loaded& loaded)
{
    if (loaded.scene)
        return model.look.camera ? *model.look.camera : loaded.scene->atTime(model.clock.time_s()).camera;
    if (model.frame.live.camera)
        return *model.frame.live.camera;
    Camera camera;
    const auto vector = [&](const char* name, const glm::dvec3& none) {
        const auto numbers = sliderOf(model, loaded, name, {none.x, none.y, none.z});
        return glm::dvec3(numbers[0], numbers[1], numbers[2]);
    };
    camera.eye = vector("u_camera_position", camera.eye);
    camera.target = vector("u_camera_target", camera.target);
    camera.fovY_deg = sliderOf(model, loaded, "u_fov_y_deg", {camera.fovY_deg})[0];
    return camera;
}

std::string pathOf(const std::string& pathAndValue)
{
    return pathAndValue.substr(0, pathAndValue.find('='));
}

void forgetGiven(LiveModel& model, const std::string& path)
{
    std::erase_if(model.given, [&](const std::string& given) { return pathOf(given) == path; });
    model.look.values.erase(path);
}

bool isOverGiven(const LiveModel& model, const std::string& path)
{
    return std::ranges::any_of(model.given,
                               [&](const std::string& given) { return overlap(path, pathOf(given)); });
}

Look wanted(const LiveModel& model)
{
    Look look = model.look;
    look.methods = drawnMethods(model.methods);
    look.overrides = model.given;
    for (const auto& [path, value] : model.changes)
        look.overrides.push_back(path + "=" + value);
    return look;
}

} // namespace dioptre
