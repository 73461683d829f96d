// What the keys do.
#include "live/camera_control.h"
#include "live/session.h"

#include "scene/choices.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr double lightStep_m = 0.25;

std::string nextOf(const std::vector<std::string>& words, const std::string& word)
{
    const auto found = std::ranges::find(words, word);
    return found == words.end() || found + 1 == words.end() ? words.front() : *(found + 1);
}

} // namespace

void Session::change(const std::string& path, const std::string& value)
{
    model_.changes[path] = value;
    ask();
}

void Session::nextLightType()
{
    const Loaded& loaded = *stage_.loaded();
    if (loaded.plain) {
        const int type = static_cast<int>(sliderOf(model_, loaded, "u_light_type", {1.0})[0]);
        model_.frame.live.lightType = static_cast<LightType>((type + 1) % 3);
        moved_ = true;
        return;
    }
    const int type = static_cast<int>(loaded.scene->scene->trace.lightType);
    change("trace.light_type", std::to_string((type + 1) % 3));
}

void Session::raiseLights(double metres)
{
    const Loaded& loaded = *stage_.loaded();
    if (loaded.plain) {
        model_.frame.live.lightHeight_m = sliderOf(model_, loaded, "u_light_height", {3.0})[0] + metres;
        moved_ = true;
        return;
    }
    const auto& lights = loaded.scene->scene->lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].kind == Light::Kind::point || lights[i].kind == Light::Kind::spot)
            model_.changes[fmt::format("light.{}.position.1", i)] =
                fmt::format("{:.2f}", lights[i].position.y + metres);
    ask();
}

void Session::nextOrder()
{
    if (!stage_.loaded()->scene)
        return;
    const TreeOrder now = stage_.loaded()->scene->scene->trace.order;
    const auto found = std::ranges::find(treeOrders, now, &NamedChoice<TreeOrder>::choice);
    const auto next = found + 1 == std::end(treeOrders) ? std::begin(treeOrders) : found + 1;
    notice(fmt::format("method: {}", next->name));
    change("trace.order", fmt::format("\"{}\"", next->name));
}

void Session::nextView()
{
    if (!stage_.loaded()->scene)
        return;
    std::vector<std::string> names{""};
    for (const auto& name : dataViewNames())
        names.push_back(name);
    const std::string now =
        model_.look.view == DataView::none ? "" : std::string(rowOf(model_.look.view).name);
    const std::string next = nextOf(names, now);
    model_.look.view = dataViewNamed(next);
    notice("view: " + (next.empty() ? "light" : next));
    ask();
}

void Session::changeBudget(int difference)
{
    if (!stage_.loaded()->scene)
        return;
    const int budget = std::clamp(stage_.loaded()->scene->prepared.plan.budget + difference, 1, 4096);
    notice(fmt::format("budget: {} rays a sample", budget));
    change("trace.budget", std::to_string(budget));
}

void Session::changeSamples(int samples)
{
    model_.look.samples = std::clamp(samples, 1, 65536);
    notice(fmt::format("{} samples a pixel", model_.look.samples));
    moved_ = true;
}

// Time's own keys. False where the action is none of them.
bool Session::actOnTime(Action action)
{
    const double step_s = 1.0 / options_.fps;
    const auto jump = [this](double seconds) { model_.clock.jumpBy(seconds); };
    switch (action) {
    case Action::pause:
        model_.clock.pause(!model_.clock.isPaused());
        break;
    case Action::stepBack:
    case Action::stepForward:
        model_.clock.pause(true);
        jump(action == Action::stepBack ? -step_s : step_s);
        break;
    case Action::scrubBack:
        jump(-1.0);
        break;
    case Action::scrubForward:
        jump(1.0);
        break;
    case Action::toStart:
        model_.clock.restart();
        break;
    case Action::restartOnReload:
        model_.restartOnReload = !model_.restartOnReload;
        notice(model_.restartOnReload ? "time begins anew with each reload" : "time goes on over reloads");
        return true;
    default:
        return false;
    }
    moved_ = moved_ || stage_.facts().usesTime;
    return true;
}

// What is traced, and how.
bool Session::actOnPicture(Action action)
{
    switch (action) {
    case Action::lightType:
        nextLightType();
        return true;
    case Action::lightUp:
    case Action::lightDown:
        raiseLights(action == Action::lightUp ? lightStep_m : -lightStep_m);
        return true;
    case Action::order:
        nextOrder();
        return true;
    case Action::view:
        nextView();
        return true;
    case Action::fewerRays:
    case Action::moreRays:
        changeBudget(action == Action::moreRays ? 1 : -1);
        return true;
    case Action::fewerSamples:
        changeSamples(model_.look.samples / 2);
        return true;
    case Action::moreSamples:
        changeSamples(model_.look.samples * 2);
        return true;
    case Action::resetCamera:
        model_.look.camera.reset();
        model_.frame.live.camera.reset();
        moved_ = true;
        return true;
    default:
        return false;
    }
}

// What leaves the window, or is taken back.
bool Session::actOnFiles(Action action)
{
    switch (action) {
    case Action::copyCamera:
        if (stage_.loaded()->scene) {
            window_.setClipboard(tomlOf(cameraOf(model_, *stage_.loaded())));
            notice("the camera is on the clipboard");
        }
        return true;
    case Action::screenshot:
        screenshot();
        return true;
    case Action::writeBack:
        writeBack();
        return true;
    case Action::discard:
        model_.changes.clear();
        model_.frame.live.sliders.clear();
        model_.frame.live.lightType.reset();
        model_.frame.live.lightHeight_m.reset();
        model_.display.reset();
        stage_.setDisplay(std::nullopt);
        ask();
        return true;
    default:
        return false;
    }
}

void Session::act(Action action)
{
    if (action == Action::help)
        model_.showHelp = !model_.showHelp;
    else if (action == Action::panel)
        model_.showPanel = !model_.showPanel;
    else if (action == Action::fullscreen)
        window_.toggleFullscreen();
    else if (action == Action::quit)
        window_.close();
    else if (stage_.loaded() != nullptr && !actOnTime(action) && !actOnPicture(action))
        actOnFiles(action);
}

} // namespace dioptre
