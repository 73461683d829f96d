// What the keys do.
#include "live/camera_control.h"
#include "live/session.h"

#include "scene/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

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

// A key that is pressed again goes on from what it asked for, which may not be shown yet.
double Session::wantedNumber(const std::string& path, double shown) const
{
    const auto asked = model_.changes.find(path);
    return asked == model_.changes.end() ? shown : std::strtod(asked->second.c_str(), nullptr);
}

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
    const std::string path = "trace.light_type";
    const int type =
        static_cast<int>(wantedNumber(path, static_cast<double>(loaded.scene->scene->trace.lightType)));
    change(path, std::to_string((type + 1) % 3));
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
        if (lights[i].kind == Light::Kind::point || lights[i].kind == Light::Kind::spot) {
            const std::string path = fmt::format("light.{}.position.1", i);
            model_.changes[path] = fmt::format("{:.2f}", wantedNumber(path, lights[i].position.y) + metres);
        }
    ask();
}

void Session::nextOrder()
{
    if (!stage_.loaded()->scene)
        return;
    const std::string path = "trace.order";
    const auto quoted = [](const auto& choice) { return fmt::format("\"{}\"", choice.name); };
    const auto asked = model_.changes.find(path);
    const auto now = std::ranges::find_if(treeOrders, [&](const auto& choice) {
        return asked != model_.changes.end() ? asked->second == quoted(choice)
                                             : choice.choice == stage_.loaded()->scene->scene->trace.order;
    });
    const auto next =
        now == std::end(treeOrders) || now + 1 == std::end(treeOrders) ? std::begin(treeOrders) : now + 1;
    notice(fmt::format("order: {}", next->name));
    change(path, quoted(*next));
}

void Session::nextView()
{
    if (!stage_.loaded()->scene)
        return;
    std::vector<std::string> names{""};
    for (const auto& name : dataViewNames())
        names.push_back(name);
    if (drawnMethods(model_.methods) != std::vector{Method{}})
        return notice("views are of a traced picture alone");
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
    const std::string path = "trace.budget";
    const int now = static_cast<int>(wantedNumber(path, stage_.loaded()->scene->prepared.plan.budget));
    const int budget = std::clamp(now + difference, 1, 4096);
    notice(fmt::format("budget: {} rays a sample", budget));
    change(path, std::to_string(budget));
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
    else if (stage_.loaded() != nullptr && !actOnTime(action) && !actOnPicture(action) &&
             !actOnMethods(action))
        actOnFiles(action);
}

} // namespace dioptre
