#include "live/panel_widgets.h"

#include "live/panel_edit.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <span>

namespace dioptre
{
namespace
{

const ImVec4 changedText(1.0F, 0.78F, 0.35F, 1.0F);
constexpr float labelShare = 0.36F; // of the panel's width
constexpr float dimmed = 0.45F;

using Rows = std::span<const PanelRow>;

// The first rows that agree with the first of all in what `key` says.
Rows sameAtFront(Rows rows, std::string PanelRow::*key)
{
    const auto other =
        std::ranges::find_if(rows, [&](const PanelRow& row) { return row.*key != rows.front().*key; });
    return rows.first(static_cast<std::size_t>(other - rows.begin()));
}

// A name with a mark where something under it was changed; what follows "###" is what ImGui knows it by.
std::string headingOf(const std::string& name, Rows rows,
                      const std::function<bool(const PanelRow&)>& isChanged)
{
    const auto changed = std::ranges::count_if(rows, isChanged);
    return changed > 0 ? fmt::format("{} ({} changed)###{}", name, changed, name)
                       : fmt::format("{}###{}", name, name);
}

void drawSections(Rows rows, const std::function<bool(const PanelRow&)>& isChanged,
                  const std::function<void(const PanelRow&)>& draw)
{
    while (!rows.empty()) {
        const Rows section = sameAtFront(rows, &PanelRow::section);
        rows = rows.subspan(section.size());
        const std::string& name = section.front().section;
        if (!name.empty() && !ImGui::TreeNodeEx(headingOf(name, section, isChanged).c_str(),
                                                ImGuiTreeNodeFlags_SpanAvailWidth))
            continue;
        std::ranges::for_each(section, draw);
        if (!name.empty())
            ImGui::TreePop();
    }
}

} // namespace

void drawRows(const std::vector<PanelRow>& all, const std::function<bool(const PanelRow&)>& isChanged,
              const std::function<void(const PanelRow&)>& draw)
{
    for (Rows rows = all; !rows.empty();) {
        const Rows group = sameAtFront(rows, &PanelRow::group);
        rows = rows.subspan(group.size());
        const bool open = group.front().section.empty() || group.back().section == group.front().section;
        const ImGuiTreeNodeFlags flags = open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
        if (ImGui::CollapsingHeader(headingOf(group.front().group, group, isChanged).c_str(), flags))
            drawSections(group, isChanged, draw);
    }
}

std::string elided(const std::string& text, float width_px)
{
    if (ImGui::CalcTextSize(text.c_str()).x <= width_px)
        return text;
    std::string cut = text;
    while (!cut.empty() && ImGui::CalcTextSize((cut + "...").c_str()).x > width_px) {
        do { // a character has one first byte
            cut.pop_back();
        } while (!cut.empty() && (static_cast<unsigned char>(text[cut.size()]) & 0xC0U) == 0x80U);
    }
    return cut + "...";
}

float labelColumn_px()
{
    return labelShare * ImGui::GetWindowContentRegionMax().x;
}

void drawLabel(const std::string& label, bool isMarked)
{
    const float room_px = labelColumn_px() - ImGui::GetCursorPosX() - ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, isMarked ? changedText : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    ImGui::TextUnformatted(elided(label, room_px).c_str());
    ImGui::PopStyleColor();
}

void drawFact(const std::string& label, const std::string& text)
{
    drawFactAt(labelColumn_px(), label, text);
}

void drawFactAt(float column_px, const std::string& label, const std::string& text)
{
    const float labelRoom_px = column_px - ImGui::GetCursorPosX() - ImGui::GetStyle().ItemInnerSpacing.x;
    const std::string shownLabel = elided(label, labelRoom_px);
    ImGui::BeginGroup();
    ImGui::TextDisabled("%s", shownLabel.c_str());
    ImGui::SameLine(column_px);
    const std::string shown = elided(text, ImGui::GetContentRegionAvail().x);
    ImGui::TextUnformatted(shown.c_str());
    ImGui::EndGroup();
    if (shown != text || shownLabel != label)
        drawHint(label + ": " + text);
}

void drawHint(const std::string& text)
{
    if (!ImGui::IsItemHovered())
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24.0F * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

RowDeed drawRow(const PanelRow& row, bool isChanged)
{
    RowDeed deed;
    ImGui::PushID(row.path.c_str());
    ImGui::PushID(static_cast<int>(row.kind));
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, row.hasEffect ? 1.0F : dimmed);
    drawLabel(row.label, isChanged);
    drawHint(fmt::format("{}{}{}{}", row.path, row.meaning.empty() ? "" : "\n" + row.meaning,
                         row.hasEffect ? "" : "\nit has no effect on the picture as it is",
                         isChanged ? "\nright click: as the file has it" : ""));
    deed.putBack = isChanged && ImGui::IsItemClicked(ImGuiMouseButton_Right);
    ImGui::SameLine(labelColumn_px());
    const float back_px = ImGui::GetFrameHeight();
    const float gap_px = ImGui::GetStyle().ItemInnerSpacing.x;
    // Room for it at all times: a slider that grew narrower would slip under the hand.
    const float width_px = ImGui::GetContentRegionAvail().x - back_px - gap_px;
    std::vector<double> numbers = row.numbers;
    if (!row.fixedBy.empty())
        ImGui::TextDisabled("%s", row.fixedBy.c_str());
    else if (editNumbers(row, numbers, width_px))
        deed.numbers = fitted(row, std::move(numbers));
    if (isChanged) {
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - back_px);
        if (ImGui::Button("\u00d7", {back_px, back_px}))
            deed.putBack = true;
        drawHint("as the file has it");
    }
    ImGui::PopStyleVar();
    ImGui::PopID();
    ImGui::PopID();
    return deed;
}

} // namespace dioptre
