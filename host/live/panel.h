// The panel: every value that can be changed, and what drawing and reloading take.
#pragma once

#include "live/ui_facts.h"
#include "render/annotation.h"

#include <map>
#include <string>
#include <vector>

namespace dioptre
{

// What a panel keeps from one frame to the next.
struct PanelState {
    // A value that the picture may be some frames behind.
    struct Pending {
        std::string value; // TOML
        std::vector<double> numbers;
    };
    std::map<std::string, Pending> pending;

    long annotated = -1; // number of the load that the next are of
    std::vector<Annotation> annotations;
    float content_px = 0.0F; // height of what is in the panel
};

// Draws it at the left, no lower than `bottom_px`, and gives where it ends to the right.
float drawPanel(const LiveModel& model, const UiFacts& facts, float bottom_px, PanelState& state,
                UiWishes& wishes);

} // namespace dioptre
