#include "live/camera_control.h"
#include "live/session.h"

#include <GLFW/glfw3.h>

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
    if (left && (event.down ? isOverDivider(event.at_px) : dividerHeld_)) {
        dividerHeld_ = event.down;
        if (!dividerHeld_)
            showChoice();
        return;
    }
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
    if (dividerHeld_)
        return drawDividerTo(event.at_px.x);
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
    model_.look.camera = rounded(camera);
    moved_ = true;
    looksElsewhere_ = true;
}

void Session::fly(double elapsed_s)
{
    flies_ = false;
    const auto either = [this](int left, int right) { return window_.isHeld(left) || window_.isHeld(right); };
    if (stage_.loaded() == nullptr || ui_.wantsKeys() ||
        either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL))
        return;
    const auto held = [this](int key) { return flyKeys_.contains(key) && window_.isHeld(key) ? 1.0 : 0.0; };
    const auto axis = [&](int more, int less) { return held(more) - held(less); };
    const glm::dvec3 way(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                         axis(GLFW_KEY_W, GLFW_KEY_S));
    if (way == glm::dvec3(0.0))
        return;
    const Camera camera = cameraOf(model_, *stage_.loaded());
    // Half of the way to the target in a second: so it is in small scenes as in large ones.
    const bool fast = either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    const double speed = 0.5 * glm::distance(camera.eye, camera.target) * (fast ? 4.0 : 1.0);
    flies_ = true;
    setCamera(flown(camera, elapsed_s * speed * way));
}

void Session::handleKey(const InputEvent& event)
{
    // A key that was pressed with Ctrl and outlasts it flies nowhere.
    if (!event.down)
        flyKeys_.erase(event.key);
    else if (!event.again && !event.control)
        flyKeys_.insert(event.key);
    if (!event.down || ui_.wantsKeys())
        return;
    if (event.key == GLFW_KEY_ESCAPE && !event.again) {
        if (model_.showHelp)
            model_.showHelp = false;
        else if (window_.isFullscreen())
            window_.toggleFullscreen();
        return;
    }
    for (const auto& binding : keyBindings())
        if (binding.key == event.key && binding.control == event.control) {
            if (!event.again || isRepeated(binding.action))
                act(binding.action);
            return;
        }
}

} // namespace dioptre
