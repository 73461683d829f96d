#include "live/model.h"

namespace dioptre
{

Camera cameraOf(const LiveModel& model, const Loaded& loaded)
{
    return model.look.camera ? *model.look.camera : loaded.scene->atTime(model.clock.time_s()).camera;
}

Look wanted(const LiveModel& model)
{
    Look look = model.look;
    look.overrides = model.given;
    for (const auto& [path, value] : model.changes)
        look.overrides.push_back(path + "=" + value);
    return look;
}

} // namespace dioptre
