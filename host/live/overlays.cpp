#include "live/overlays.h"

#include "live/keys.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr ImU32 red = IM_COL32(235, 60, 50, 255);
const ImVec4 redText(1.0F, 0.45F, 0.4F, 1.0F);
const ImVec4 dimText(0.7F, 0.7F, 0.7F, 1.0F);
const ImVec4 hereText(1.0F, 0.9F, 0.6F, 1.0F);

constexpr ImGuiWindowFlags overlayFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

void drawPlace(const FaultPlace& place)
{
    const auto& [complaint, excerpt] = place;
    const std::string where = describe(complaint.where);
    if (!where.empty())
        ImGui::TextColored(redText, "%s", where.c_str());
    ImGui::TextWrapped("%s", complaint.what.c_str());
    if (!complaint.mend.empty())
        ImGui::TextColored(dimText, "%s", complaint.mend.c_str());
    for (std::size_t i = 0; i < excerpt.lines.size(); ++i) {
        const int number = excerpt.first + static_cast<int>(i);
        const bool here = number == complaint.where.line;
        ImGui::TextColored(here ? hereText : dimText, "%s",
                           fmt::format("{}{:5} | {}", here ? '>' : ' ', number, excerpt.lines[i]).c_str());
        if (here && complaint.where.column > 0)
            ImGui::TextColored(redText, "%s",
                               fmt::format("{:7}| {:>{}}", "", '^', complaint.where.column).c_str());
    }
    ImGui::Spacing();
}

} // namespace

void drawStaleMark()
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRect({2.0F, 2.0F}, {size.x - 2.0F, size.y - 2.0F}, red, 0.0F, 0, 4.0F);
    const char* const words = "STALE: the last picture that was good";
    const ImVec2 extent = ImGui::CalcTextSize(words);
    const ImVec2 at(0.5F * (size.x - extent.x), 6.0F);
    draw.AddRectFilled({at.x - 8.0F, 2.0F}, {at.x + extent.x + 8.0F, at.y + extent.y + 4.0F}, red);
    draw.AddText(at, IM_COL32_WHITE, words);
}

void drawFault(const Fault& fault)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float height = std::min(0.45F * size.y, 320.0F);
    ImGui::SetNextWindowPos({8.0F, size.y - height - 8.0F});
    ImGui::SetNextWindowSize({size.x - 16.0F, height});
    ImGui::SetNextWindowBgAlpha(0.88F);
    ImGui::PushStyleColor(ImGuiCol_Border, red);
    ImGui::Begin("error", nullptr, overlayFlags | ImGuiWindowFlags_HorizontalScrollbar);
    for (const auto& place : fault.places)
        drawPlace(place);
    if (fault.places.empty())
        ImGui::TextWrapped("%s", fault.text.c_str());
    ImGui::End();
    ImGui::PopStyleColor();
}

void drawHelp()
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.92F);
    ImGui::Begin("keys", nullptr, overlayFlags | ImGuiWindowFlags_AlwaysAutoResize);
    const auto row = [](const char* left, const char* right) {
        ImGui::TextColored(hereText, "%-22s", left);
        ImGui::SameLine();
        ImGui::TextUnformatted(right);
    };
    const char* last = "";
    for (const auto& binding : keyBindings()) {
        if (binding.keys != std::string_view(last))
            row(binding.keys, binding.meaning);
        last = binding.keys;
    }
    ImGui::Separator();
    for (const auto& each : gestures())
        row(each.gesture, each.meaning);
    ImGui::End();
}

void drawNotice(const std::string& text)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, 28.0F}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.85F);
    ImGui::Begin("notice", nullptr,
                 overlayFlags | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
}

} // namespace dioptre
