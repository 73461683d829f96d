// The panel, messages and help over the picture, by Dear ImGui.
#pragma once

#include "live/keys.h"
#include "live/model.h"
#include "live/stage.h"
#include "live/window.h"

#include <deque>

namespace dioptre
{

// What a user did in the panel.
struct UiWishes {
    std::map<std::string, std::string> changes;         // of a scene, path to value
    std::map<std::string, std::vector<double>> sliders; // of a plain shader
    std::optional<std::optional<Display>> display;      // another one
    std::optional<double> time_s;                       // scrubbed to
    std::vector<Action> actions;
};

// What is shown beside the model.
struct UiFacts {
    const Stage& stage;
    const std::deque<float>& frames_ms; // between the last frames
    double compilingFor_s = 0.0;        // 0 where nothing is
    const ContextInfo& context;
};

class Ui
{
public:
    explicit Ui(const Window& window);
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;
    ~Ui();

    // Draws over what the window's back buffer holds.
    UiWishes draw(const LiveModel& model, const UiFacts& facts);

    // Whether the pointer or the keys are the panel's.
    bool wantsPointer() const;
    bool wantsKeys() const;
};

} // namespace dioptre
