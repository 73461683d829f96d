// What each key does: the one table that the window obeys and that its help shows.
#pragma once

#include <span>

namespace dioptre
{

enum class Action {
    help,
    panel,
    fullscreen,
    quit,
    pause,
    stepBack,
    stepForward,
    scrubBack,
    scrubForward,
    toStart,
    restartOnReload,
    lightType,
    lightUp,
    lightDown,
    order,
    view,
    compare,
    flip,
    differenceScale,
    wires,
    fewerRays,
    moreRays,
    fewerSamples,
    moreSamples,
    resetCamera,
    copyCamera,
    screenshot,
    writeBack,
    discard
};

struct KeyBinding {
    Action action;
    int key; // GLFW's
    bool control;
    const char* keys; // for people
    const char* meaning;
};

std::span<const KeyBinding> keyBindings();

// Whether it is done again and again while its key is held.
bool isRepeated(Action action);

// What the mouse and the held keys do, for the help.
struct Gesture {
    const char* gesture;
    const char* meaning;
};
std::span<const Gesture> gestures();

} // namespace dioptre
