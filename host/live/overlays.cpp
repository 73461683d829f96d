#include "live/overlays.h"

#include "live/excerpt_line.h"
#include "live/keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace dioptre
{
namespace
{

constexpr ImU32 red = IM_COL32(235, 60, 50, 255);
const ImVec4 redText(1.0F, 0.45F, 0.4F, 1.0F);
const ImVec4 dimText(0.7F, 0.7F, 0.7F, 1.0F);
const ImVec4 mendText(0.6F, 0.85F, 1.0F, 1.0F);
const ImVec4 hereText(1.0F, 0.9F, 0.6F, 1.0F);

constexpr ImGuiWindowFlags overlayFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

constexpr float overlayMargin_px = 8.0F;

// Drivers' columns are bytes of a shader, those of TOML are not.
ColumnUnit unitOf(const SourcePosition& where)
{
    return where.path.ends_with(".toml") ? ColumnUnit::codePoints : ColumnUnit::bytes;
}

void drawExcerpt(const SourceExcerpt& excerpt, const SourcePosition& where)
{
    for (std::size_t i = 0; i < excerpt.lines.size(); ++i) {
        const int number = excerpt.first + static_cast<int>(i);
        const bool here = number == where.line;
        const ShownLine line = shownLine(excerpt.lines[i], here ? where.column : 0, unitOf(where));
        ImGui::TextColored(here ? hereText : dimText, "%s",
                           fmt::format("{}{:5} | {}", here ? '>' : ' ', number, line.text).c_str());
        if (line.caret >= 0)
            ImGui::TextColored(redText, "%s", fmt::format("{:6} | {:{}}^", "", "", line.caret).c_str());
    }
}

void drawPlace(const FaultPlace& place, ImFont* code)
{
    const auto& [complaint, excerpt] = place;
    // Long words wrap in the window, whatever the widest line of a source is.
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - 2.0F * overlayMargin_px -
                           ImGui::GetStyle().ScrollbarSize);
    if (const std::string where = describe(complaint.where); !where.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, redText);
        ImGui::TextWrapped("%s", where.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::TextUnformatted(complaint.what.c_str());
    if (!complaint.mend.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, mendText);
        ImGui::TextUnformatted(complaint.mend.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::PushFont(code);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.0F});
    drawExcerpt(excerpt, complaint.where);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::Spacing();
}

// All keys that do what a binding does, each once; "" where an earlier one has told of them.
std::string keysOf(std::span<const KeyBinding> bindings, std::size_t index)
{
    const Action action = bindings[index].action;
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        if (bindings[i].action != action)
            continue;
        if (i < index)
            return "";
        if (std::ranges::find(keys, bindings[i].keys) == keys.end())
            keys.emplace_back(bindings[i].keys);
    }
    return fmt::format("{}", fmt::join(keys, "  "));
}

// The middle of what the panel leaves of the window.
float middle_px(float left_px)
{
    return 0.5F * (left_px + ImGui::GetIO().DisplaySize.x);
}

} // namespace

float faultHeight_px()
{
    return std::min(0.45F * ImGui::GetIO().DisplaySize.y, 20.0F * ImGui::GetFontSize());
}

void drawStaleMark(float left_px)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRect({2.0F, 2.0F}, {size.x - 2.0F, size.y - 2.0F}, red, 0.0F, 0, 4.0F);
    const char* words = "STALE: the last picture that was good";
    if (ImGui::CalcTextSize(words).x + 4.0F * overlayMargin_px > size.x - left_px)
        words = "STALE";
    const ImVec2 extent = ImGui::CalcTextSize(words);
    const ImVec2 at(middle_px(left_px) - 0.5F * extent.x, 6.0F);
    draw.AddRectFilled({at.x - 8.0F, 2.0F}, {at.x + extent.x + 8.0F, at.y + extent.y + 4.0F}, red);
    draw.AddText(at, IM_COL32_WHITE, words);
}

void drawFault(const Fault& fault, ImFont* code)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    // As high as its text, from the lower edge, and no higher than the panel leaves room.
    const float width = size.x - 2.0F * overlayMargin_px;
    ImGui::SetNextWindowPos({overlayMargin_px, size.y - overlayMargin_px}, ImGuiCond_Always, {0.0F, 1.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, faultHeight_px()});
    ImGui::SetNextWindowBgAlpha(0.92F);
    ImGui::PushStyleColor(ImGuiCol_Border, red);
    ImGui::Begin("error", nullptr,
                 overlayFlags | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_HorizontalScrollbar);
    for (const auto& place : fault.places)
        drawPlace(place, code);
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
        ImGui::TextColored(hereText, "%s", left);
        ImGui::SameLine(11.0F * ImGui::GetFontSize());
        ImGui::TextUnformatted(right);
    };
    const auto bindings = keyBindings();
    for (std::size_t i = 0; i < bindings.size(); ++i)
        if (const std::string keys = keysOf(bindings, i); !keys.empty())
            row(keys.c_str(), bindings[i].meaning);
    ImGui::Separator();
    for (const auto& each : gestures())
        row(each.gesture, each.meaning);
    ImGui::End();
}

void drawNotice(const std::string& text, float left_px)
{
    ImGui::SetNextWindowPos({middle_px(left_px), 2.2F * ImGui::GetFontSize()}, ImGuiCond_Always,
                            {0.5F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.85F);
    ImGui::Begin("notice", nullptr,
                 overlayFlags | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
}

} // namespace dioptre
