// The panel, messages and help over the picture, by Dear ImGui.
#pragma once

#include "live/panel.h"
#include "live/ui_facts.h"
#include "live/window.h"

struct ImFont;

namespace dioptre
{

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

private:
    PanelState panel_;
    ImFont* code_ = nullptr; // of one width, for sources
};

} // namespace dioptre
