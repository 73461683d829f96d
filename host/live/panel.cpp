#include "live/panel.h"

#include <imgui.h>

namespace dioptre
{

void drawPanel(const LiveModel& model, const UiFacts& facts, UiWishes& wishes)
{
    ImGui::SetNextWindowPos({8.0F, 8.0F}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({320.0F, 420.0F}, ImGuiCond_FirstUseEver);
    ImGui::Begin("dioptre");
    ImGui::Text("%.1f ms a sample, %d of %d", facts.stage.facts().sample_ms, facts.stage.samplesDone(),
                model.look.samples);
    static_cast<void>(wishes);
    ImGui::End();
}

} // namespace dioptre
