#include "live/keys.h"

#include <GLFW/glfw3.h>

#include <array>

namespace dioptre
{

std::span<const KeyBinding> keyBindings()
{
    static constexpr std::array bindings{
        KeyBinding{Action::help, GLFW_KEY_F1, false, "F1", "this help"},
        KeyBinding{Action::help, GLFW_KEY_H, false, "H", "this help"},
        KeyBinding{Action::panel, GLFW_KEY_TAB, false, "Tab", "show or hide the panel"},
        KeyBinding{Action::fullscreen, GLFW_KEY_F11, false, "F11", "fullscreen and back"},
        KeyBinding{Action::quit, GLFW_KEY_Q, true, "Ctrl+Q", "close the window"},
        KeyBinding{Action::pause, GLFW_KEY_SPACE, false, "Space", "hold time, or let it run"},
        KeyBinding{Action::stepBack, GLFW_KEY_COMMA, false, ",", "a frame back"},
        KeyBinding{Action::stepForward, GLFW_KEY_PERIOD, false, ".", "a frame forward"},
        KeyBinding{Action::scrubBack, GLFW_KEY_LEFT, false, "Left", "a second back"},
        KeyBinding{Action::scrubForward, GLFW_KEY_RIGHT, false, "Right", "a second forward"},
        KeyBinding{Action::toStart, GLFW_KEY_HOME, false, "Home", "time to its start"},
        KeyBinding{Action::restartOnReload, GLFW_KEY_T, false, "T", "whether time begins anew with a reload"},
        KeyBinding{Action::lightType, GLFW_KEY_L, false, "L", "light type: unlit, lit, lights only"},
        KeyBinding{Action::lightUp, GLFW_KEY_PAGE_UP, false, "Page up", "lights higher"},
        KeyBinding{Action::lightDown, GLFW_KEY_PAGE_DOWN, false, "Page down", "lights lower"},
        KeyBinding{Action::order, GLFW_KEY_M, false, "M", "the next order of the ray tree"},
        KeyBinding{Action::view, GLFW_KEY_V, false, "V", "the next view: light, rays, lost, object, ..."},
        KeyBinding{Action::compare, GLFW_KEY_B, false, "B", "two methods: split, difference, off"},
        KeyBinding{Action::flip, GLFW_KEY_X, false, "X", "flip between the two in full"},
        KeyBinding{Action::differenceScale, GLFW_KEY_K, false, "K", "the next scale of the difference"},
        KeyBinding{Action::wires, GLFW_KEY_G, false, "G", "edges of the facets, or none"},
        KeyBinding{Action::fewerRays, GLFW_KEY_MINUS, false, "-", "a smaller budget of rays"},
        KeyBinding{Action::moreRays, GLFW_KEY_EQUAL, false, "+", "a larger budget of rays"},
        KeyBinding{Action::moreRays, GLFW_KEY_KP_ADD, false, "+", "a larger budget of rays"},
        KeyBinding{Action::fewerRays, GLFW_KEY_KP_SUBTRACT, false, "-", "a smaller budget of rays"},
        KeyBinding{Action::fewerSamples, GLFW_KEY_LEFT_BRACKET, false, "[", "half as many samples a pixel"},
        KeyBinding{Action::moreSamples, GLFW_KEY_RIGHT_BRACKET, false, "]", "twice as many samples a pixel"},
        KeyBinding{Action::resetCamera, GLFW_KEY_R, false, "R", "the scene's own camera again"},
        KeyBinding{Action::copyCamera, GLFW_KEY_C, false, "C", "copy the camera as TOML"},
        KeyBinding{Action::screenshot, GLFW_KEY_P, false, "P", "write a screenshot"},
        KeyBinding{Action::screenshot, GLFW_KEY_F12, false, "F12", "write a screenshot"},
        KeyBinding{Action::writeBack, GLFW_KEY_S, true, "Ctrl+S", "write changed values into the file"},
        KeyBinding{Action::discard, GLFW_KEY_Z, true, "Ctrl+Z", "drop all changed values"},
    };
    return bindings;
}

bool isRepeated(Action action)
{
    switch (action) {
    case Action::stepBack:
    case Action::stepForward:
    case Action::scrubBack:
    case Action::scrubForward:
    case Action::lightUp:
    case Action::lightDown:
    case Action::fewerRays:
    case Action::moreRays:
    case Action::fewerSamples:
    case Action::moreSamples:
        return true;
    default: // a switch, or a deed
        return false;
    }
}

std::span<const Gesture> gestures()
{
    static constexpr std::array all{
        Gesture{"drag", "orbit round the target; a shader's mouse"},
        Gesture{"drag the divider", "more of one method, less of the other"},
        Gesture{"right drag", "turn the head"},
        Gesture{"middle or shift drag", "move sideways"},
        Gesture{"wheel", "field of view"},
        Gesture{"W A S D Q E", "fly; Shift: fast"},
        Gesture{"drop a file", "open a scene, a shader or a picture"},
    };
    return all;
}

} // namespace dioptre
