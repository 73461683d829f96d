#include "live/panel.h"

#include "live/panel_figures.h"
#include "live/panel_values.h"
#include "live/panel_widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr float margin_px = 8.0F;
constexpr float widthInLetters = 22.7F; // heights of a letter
constexpr float mostOfWindow = 0.62F;

// As many in a line as fit.
void drawButton(const char* label, const char* hint, Action action, UiWishes& wishes, bool first = false)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width_px = ImGui::CalcTextSize(label, nullptr, true).x + 2.0F * style.FramePadding.x;
    if (!first) {
        ImGui::SameLine(0.0F, style.ItemInnerSpacing.x);
        if (ImGui::GetContentRegionAvail().x < width_px)
            ImGui::NewLine();
    }
    if (ImGui::Button(label))
        wishes.actions.push_back(action);
    drawHint(hint);
}

void drawButtons(bool isScene, UiWishes& wishes)
{
    drawButton("write", "write changed values into the file (Ctrl+S)", Action::writeBack, wishes, true);
    drawButton("drop all", "drop all changed values (Ctrl+Z)", Action::discard, wishes);
    drawButton("camera", "its own camera again (R)", Action::resetCamera, wishes);
    drawButton("shot", "write a screenshot (P)", Action::screenshot, wishes);
    if (isScene)
        drawButton("view", "the next view: light, rays, lost, object, ... (V)", Action::view, wishes);
    drawButton("keys", "keys and mouse (F1)", Action::help, wishes);
}

void drawTime(const LiveModel& model, UiWishes& wishes)
{
    const bool paused = model.clock.isPaused();
    double time_s = model.clock.time_s();
    drawLabel("time, s");
    ImGui::SameLine(labelColumn_px());
    const float button_px = ImGui::GetFrameHeight();
    const float gap_px = ImGui::GetStyle().ItemInnerSpacing.x;
    const float play_px = 2.6F * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 3.0F * (button_px + gap_px) - play_px -
                            gap_px);
    if (ImGui::DragScalar("##time", ImGuiDataType_Double, &time_s, 0.02F, nullptr, nullptr, "%.2f"))
        wishes.time_s = time_s;
    drawHint("drag to scrub, Ctrl and a click to type");
    const auto button = [&](const char* label, float width_px, const char* hint, Action action) {
        ImGui::SameLine(0.0F, gap_px);
        if (ImGui::Button(label, {width_px, 0.0F}))
            wishes.actions.push_back(action);
        drawHint(hint);
    };
    button("|<", button_px, "to the start (Home)", Action::toStart);
    button("<", button_px, "a frame back", Action::stepBack);
    button(paused ? "play" : "hold", play_px, "hold time, or let it run (Space)", Action::pause);
    button(">", button_px, "a frame forward", Action::stepForward);
}

void drawSamples(const LiveModel& model, const UiFacts& facts, UiWishes& wishes)
{
    const int wanted = facts.stage.loaded()->plain ? 1 : model.look.samples;
    const int done = std::min(facts.stage.samplesDone(), wanted);
    drawLabel("samples");
    ImGui::SameLine(labelColumn_px());
    const float button_px = ImGui::GetFrameHeight();
    const float gap_px = ImGui::GetStyle().ItemInnerSpacing.x;
    const bool isScene = facts.stage.loaded()->scene.has_value();
    const float width_px = ImGui::GetContentRegionAvail().x - (isScene ? 2.0F * (button_px + gap_px) : 0.0F);
    ImGui::ProgressBar(static_cast<float>(done) / static_cast<float>(std::max(wanted, 1)), {width_px, 0.0F},
                       fmt::format("{} of {}", done, wanted).c_str());
    if (!isScene)
        return;
    for (const auto& [label, action, hint] :
         {std::tuple{"-", Action::fewerSamples, "half as many a pixel ([)"},
          std::tuple{"+", Action::moreSamples, "twice as many a pixel (])"}}) {
        ImGui::SameLine(0.0F, gap_px);
        if (ImGui::Button(label, {button_px, 0.0F}))
            wishes.actions.push_back(action);
        drawHint(hint);
    }
}

void drawContent(const LiveModel& model, const UiFacts& facts, PanelState& state, UiWishes& wishes)
{
    drawState(model, facts);
    if (facts.stage.loaded() == nullptr)
        return;
    drawButtons(facts.stage.loaded()->scene.has_value(), wishes);
    if (facts.stage.facts().usesTime)
        drawTime(model, wishes);
    drawSamples(model, facts, wishes);
    drawLegend(facts);
    drawValues(model, *facts.stage.loaded(), facts.stage.facts(), state, wishes);
    drawFigures(model, facts);
}

} // namespace

float drawPanel(const LiveModel& model, const UiFacts& facts, float bottom_px, PanelState& state,
                UiWishes& wishes)
{
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width_px = std::min(widthInLetters * ImGui::GetFontSize(), mostOfWindow * window.x);
    const float room_px = std::max(bottom_px - 2.0F * margin_px, 4.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({margin_px, margin_px});
    ImGui::SetNextWindowSize(
        {width_px, state.content_px > 0.0F ? std::min(state.content_px, room_px) : room_px});
    ImGui::SetNextWindowBgAlpha(0.86F);
    const bool open =
        ImGui::Begin(fmt::format("{}###panel", model.look.input.name).c_str(), nullptr,
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
    if (open) {
        drawContent(model, facts, state, wishes);
        state.content_px = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
    }
    ImGui::End();
    return margin_px + width_px;
}

} // namespace dioptre
