#include "live/camera_control.h"
#include "live/session.h"

#include "scene/choices.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr double pi = 3.14159265358979323846;

// A drag over the picture's height turns by half a circle.
double turnOf(double pixels, int height_px)
{
    return pi * pixels / height_px;
}

std::string nextOf(const std::vector<std::string>& words, const std::string& word)
{
    const auto found = std::ranges::find(words, word);
    return found == words.end() || found + 1 == words.end() ? words.front() : *(found + 1);
}

} // namespace

void Session::handle(const InputEvent& event)
{
    switch (event.kind) {
    case InputEvent::Kind::key:
        return handleKey(event);
    case InputEvent::Kind::button:
        return handleButton(event);
    case InputEvent::Kind::move:
        return handleMove(event);
    case InputEvent::Kind::scroll:
        if (!ui_.wantsPointer() && stage_.loaded() != nullptr)
            setCamera(zoomed(cameraOf(model_, *stage_.loaded()), event.scroll));
        return;
    case InputEvent::Kind::drop:
        if (!event.files.empty())
            open(event.files.front());
        return;
    }
}

void Session::handleButton(const InputEvent& event)
{
    if (event.down && ui_.wantsPointer())
        return;
    const bool left = event.key == GLFW_MOUSE_BUTTON_LEFT;
    pointer_px_ = event.at_px;
    if (event.down)
        dragged_ = left && event.shift ? GLFW_MOUSE_BUTTON_MIDDLE : event.key;
    else
        dragged_ = -1;
    if (!left || stage_.loaded() == nullptr || !stage_.loaded()->plain)
        return;
    if (event.down)
        model_.frame.pointer.press(event.at_px.x, event.at_px.y);
    else
        model_.frame.pointer.release();
    moved_ = moved_ || stage_.facts().usesPointer;
}

void Session::handleMove(const InputEvent& event)
{
    const glm::dvec2 by_px = event.at_px - pointer_px_;
    pointer_px_ = event.at_px;
    if (stage_.loaded() == nullptr)
        return;
    if (stage_.loaded()->plain) {
        model_.frame.pointer.move(event.at_px.x, event.at_px.y);
        moved_ = moved_ || stage_.facts().usesPointer;
    }
    if (dragged_ < 0 || by_px == glm::dvec2(0.0))
        return;
    const int height_px = model_.look.size_px.y;
    const double right = turnOf(by_px.x, height_px), up = turnOf(by_px.y, height_px);
    const Camera camera = cameraOf(model_, *stage_.loaded());
    if (dragged_ == GLFW_MOUSE_BUTTON_RIGHT)
        setCamera(turned(camera, -0.5 * right, -0.5 * up));
    else if (dragged_ == GLFW_MOUSE_BUTTON_MIDDLE)
        setCamera(panned(camera, -by_px.x / height_px, -by_px.y / height_px));
    else
        setCamera(orbited(camera, right, up));
}

void Session::setCamera(const Camera& camera)
{
    if (stage_.loaded()->plain) {
        model_.frame.live.camera = camera;
        moved_ = true;
        return;
    }
    model_.look.camera = camera;
    moved_ = true;
    looksElsewhere_ = true;
}

void Session::fly(double elapsed_s)
{
    if (stage_.loaded() == nullptr || ui_.wantsKeys() || window_.isHeld(GLFW_KEY_LEFT_CONTROL))
        return;
    const auto axis = [this](int more, int less) {
        return (window_.isHeld(more) ? 1.0 : 0.0) - (window_.isHeld(less) ? 1.0 : 0.0);
    };
    const glm::dvec3 way(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                         axis(GLFW_KEY_W, GLFW_KEY_S));
    if (way == glm::dvec3(0.0))
        return;
    const Camera camera = cameraOf(model_, *stage_.loaded());
    // Half of the way to the target in a second: so it is in small scenes as in large ones.
    const double speed =
        0.5 * glm::distance(camera.eye, camera.target) * (window_.isHeld(GLFW_KEY_LEFT_SHIFT) ? 4.0 : 1.0);
    setCamera(flown(camera, elapsed_s * speed * way));
}

void Session::handleKey(const InputEvent& event)
{
    if (!event.down || ui_.wantsKeys())
        return;
    if (event.key == GLFW_KEY_ESCAPE) {
        if (model_.showHelp)
            model_.showHelp = false;
        else if (window_.isFullscreen())
            window_.toggleFullscreen();
        return;
    }
    for (const auto& binding : keyBindings())
        if (binding.key == event.key && binding.control == event.control)
            return act(binding.action);
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

void Session::act(Action action)
{
    if (stage_.loaded() == nullptr && action != Action::quit && action != Action::help)
        return;
    const double step_s = 1.0 / options_.fps;
    const auto jump = [this](double seconds) {
        model_.clock.jumpBy(seconds);
        moved_ = true;
    };
    switch (action) {
    case Action::help:
        model_.showHelp = !model_.showHelp;
        break;
    case Action::panel:
        model_.showPanel = !model_.showPanel;
        break;
    case Action::fullscreen:
        window_.toggleFullscreen();
        break;
    case Action::quit:
        window_.close();
        break;
    case Action::pause:
        model_.clock.pause(!model_.clock.isPaused());
        moved_ = true;
        break;
    case Action::stepBack:
        model_.clock.pause(true);
        jump(-step_s);
        break;
    case Action::stepForward:
        model_.clock.pause(true);
        jump(step_s);
        break;
    case Action::scrubBack:
        jump(-1.0);
        break;
    case Action::scrubForward:
        jump(1.0);
        break;
    case Action::toStart:
        model_.clock.restart();
        moved_ = true;
        break;
    case Action::restartOnReload:
        model_.restartOnReload = !model_.restartOnReload;
        notice(model_.restartOnReload ? "time begins anew with each reload" : "time goes on over reloads");
        break;
    case Action::lightType:
        nextLightType();
        break;
    case Action::lightUp:
        raiseLights(0.25);
        break;
    case Action::lightDown:
        raiseLights(-0.25);
        break;
    case Action::order:
        nextOrder();
        break;
    case Action::view:
        nextView();
        break;
    case Action::fewerRays:
        changeBudget(-1);
        break;
    case Action::moreRays:
        changeBudget(1);
        break;
    case Action::fewerSamples:
        changeSamples(model_.look.samples / 2);
        break;
    case Action::moreSamples:
        changeSamples(model_.look.samples * 2);
        break;
    case Action::resetCamera:
        model_.look.camera.reset();
        model_.frame.live.camera.reset();
        moved_ = true;
        break;
    case Action::copyCamera:
        if (stage_.loaded()->scene) {
            window_.setClipboard(tomlOf(cameraOf(model_, *stage_.loaded())));
            notice("the camera is on the clipboard");
        }
        break;
    case Action::screenshot:
        screenshot();
        break;
    case Action::writeBack:
        writeBack();
        break;
    case Action::discard:
        model_.changes.clear();
        model_.frame.live.sliders.clear();
        model_.display.reset();
        stage_.setDisplay(std::nullopt);
        ask();
        break;
    }
}

} // namespace dioptre
