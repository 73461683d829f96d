#include "live/panel_edit.h"

#include "base/srgb.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// As many digits as a step of the slider is worth.
const char* formatOf(const PanelRow& row)
{
    if (row.logarithmic)
        return "%.4g";
    const double span = row.high - row.low;
    return span > 1000.0 ? "%.2f" : span > 50.0 ? "%.1f" : span > 4.0 ? "%.2f" : "%.3f";
}

bool editChoice(const PanelRow& row, double& chosen)
{
    const auto place = std::min(static_cast<std::size_t>(std::max(chosen, 0.0)), row.words.size() - 1);
    bool changed = false;
    if (!ImGui::BeginCombo("##choice", row.words[place].label.c_str()))
        return false;
    for (std::size_t i = 0; i < row.words.size(); ++i)
        if (ImGui::Selectable(row.words[i].label.c_str(), i == place)) {
            chosen = static_cast<double>(i);
            changed = true;
        }
    ImGui::EndCombo();
    return changed;
}

bool editToggles(std::vector<double>& numbers)
{
    bool changed = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        bool on = numbers[i] != 0.0;
        ImGui::PushID(static_cast<int>(i));
        if (i > 0)
            ImGui::SameLine();
        changed = ImGui::Checkbox("##on", &on) || changed;
        numbers[i] = on ? 1.0 : 0.0;
        ImGui::PopID();
    }
    return changed;
}

bool editIntegers(const PanelRow& row, std::vector<double>& numbers)
{
    std::vector<int> whole;
    for (const double number : numbers)
        whole.push_back(static_cast<int>(std::lround(std::clamp(number, -1e9, 1e9))));
    const int low = static_cast<int>(std::clamp(row.low, -1e9, 1e9));
    const int high = static_cast<int>(std::clamp(row.high, -1e9, 1e9));
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp |
                                   (row.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    const char* const format = row.unset.empty() ? "%d" : row.unset.c_str();
    const bool changed = ImGui::SliderScalarN("##whole", ImGuiDataType_S32, whole.data(),
                                              static_cast<int>(whole.size()), &low, &high, format, flags);
    if (changed)
        numbers.assign(whole.begin(), whole.end());
    return changed;
}

// Numbers in place of a slider: the range is too wide for one.
bool dragNumbers(const PanelRow& row, std::vector<double>& numbers)
{
    double reach = 0.0;
    for (const double number : numbers)
        reach = std::max(reach, std::abs(number));
    const auto speed = static_cast<float>(std::max(0.004, 0.01 * reach));
    return ImGui::DragScalarN("##numbers", ImGuiDataType_Double, numbers.data(),
                              static_cast<int>(numbers.size()), speed, &row.low, &row.high, "%.3g",
                              ImGuiSliderFlags_AlwaysClamp);
}

// A colour as a display shows it, brighter ones at its own brightest.
ImVec4 shownColour(const PanelRow& row, const std::vector<double>& numbers)
{
    const double brightest = std::max({1.0, numbers[0], numbers[1], numbers[2]});
    const auto channel = [&](std::size_t i) {
        const double value = std::max(numbers[i], 0.0) / brightest;
        return static_cast<float>(row.isEncoded ? value : srgbFromLinear(value));
    };
    return {channel(0), channel(1), channel(2), 1.0F};
}

bool pickColour(const PanelRow& row, std::vector<double>& numbers)
{
    const double brightest = std::max({1.0, numbers[0], numbers[1], numbers[2]});
    const ImVec4 shown = shownColour(row, numbers);
    float picked[3] = {shown.x, shown.y, shown.z};
    if (!ImGui::ColorPicker3("##picker", picked,
                             ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayHex |
                                 ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_PickerHueWheel))
        return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = static_cast<double>(picked[i]);
        numbers[i] = brightest * (row.isEncoded ? value : linearFromSrgb(value));
    }
    return true;
}

bool editColour(const PanelRow& row, std::vector<double>& numbers, float width_px)
{
    const float side_px = ImGui::GetFrameHeight();
    const float gap_px = ImGui::GetStyle().ItemInnerSpacing.x;
    bool changed = false;
    if (ImGui::ColorButton("##swatch", shownColour(row, numbers), ImGuiColorEditFlags_NoTooltip,
                           {side_px, side_px}))
        ImGui::OpenPopup("picker");
    if (ImGui::BeginPopup("picker")) {
        ImGui::SetNextItemWidth(14.0F * ImGui::GetFontSize());
        changed = pickColour(row, numbers);
        ImGui::EndPopup();
    }
    ImGui::SameLine(0.0F, gap_px);
    ImGui::SetNextItemWidth(width_px - side_px - gap_px);
    return dragNumbers(row, numbers) || changed;
}

} // namespace

bool editNumbers(const PanelRow& row, std::vector<double>& numbers, float width_px)
{
    ImGui::SetNextItemWidth(width_px);
    switch (row.kind) {
    case RowKind::choice:
        return editChoice(row, numbers.front());
    case RowKind::toggle:
        return editToggles(numbers);
    case RowKind::integer:
        return editIntegers(row, numbers);
    case RowKind::colour:
        return editColour(row, numbers, width_px);
    case RowKind::vector:
        return dragNumbers(row, numbers);
    case RowKind::number:
        break;
    }
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp |
                                   (row.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    return ImGui::SliderScalar("##number", ImGuiDataType_Double, numbers.data(), &row.low, &row.high,
                               formatOf(row), flags);
}

} // namespace dioptre
