// What the panel is told and what it says.
#pragma once

#include "live/keys.h"
#include "live/model.h"
#include "live/stage.h"

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// What a user did in the panel.
struct UiWishes {
    std::map<std::string, std::string> changes;         // of a scene, path to value
    std::map<std::string, std::vector<double>> sliders; // of a plain shader
    std::vector<std::string> dropped;                   // changes and sliders that are no more
    std::optional<std::optional<Display>> display;      // another one
    std::optional<MethodChoice> methods;                // likewise
    std::optional<Camera> camera;                       // of a scene
    std::optional<double> time_s;                       // scrubbed to
    std::vector<Action> actions;
};

// What is shown beside the model.
struct UiFacts {
    const Stage& stage;
    const std::deque<float>& frames_ms; // between the last frames
    double compilingFor_s = 0.0;        // 0 where nothing is
    const ContextInfo& context;
    bool dividerHeld = false; // by the hand
};

} // namespace dioptre
