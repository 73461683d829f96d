#include "live/overlay_compare.h"

#include "live/divider.h"

#include <imgui.h>

#include <string>

namespace dioptre
{
namespace
{

constexpr ImU32 paper = IM_COL32(20, 20, 24, 190);
constexpr ImU32 ink = IM_COL32(255, 255, 255, 255);
constexpr ImU32 rim = IM_COL32(0, 0, 0, 160);
constexpr float plateTop_px = 8.0F;
constexpr float plateGap_px = 8.0F;
constexpr float platePadding_px = 5.0F;

// `share`: of its width that lies left of `x_px`.
void drawPlate(const std::string& text, float x_px, float share)
{
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const float width = extent.x + 2.0F * platePadding_px;
    const ImVec2 at(x_px - share * width, plateTop_px);
    draw.AddRectFilled(at, {at.x + width, at.y + extent.y + platePadding_px}, paper, 3.0F);
    draw.AddText({at.x + platePadding_px, at.y + 0.5F * platePadding_px}, ink, text.c_str());
}

void drawDivider(float x_px, bool lit)
{
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float height = ImGui::GetIO().DisplaySize.y;
    const float half = lit ? 1.5F : 0.5F;
    draw.AddRectFilled({x_px - half - 1.0F, 0.0F}, {x_px + half + 1.0F, height}, rim);
    draw.AddRectFilled({x_px - half, 0.0F}, {x_px + half, height}, ink);
    const float middle = 0.5F * height;
    draw.AddRectFilled({x_px - 4.0F, middle - 14.0F}, {x_px + 4.0F, middle + 14.0F}, rim, 4.0F);
    draw.AddRectFilled({x_px - 3.0F, middle - 13.0F}, {x_px + 3.0F, middle + 13.0F}, ink, 3.0F);
}

} // namespace

void drawComparison(const MethodChoice& choice, bool held, float left_px)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (choice.comparison == Comparison::off)
        return;
    if (choice.comparison != Comparison::split)
        return drawPlate(nameOf(choice), 0.5F * (left_px + io.DisplaySize.x), 0.5F);
    const auto column = static_cast<float>(
        dividerColumn_px(choice.divider, static_cast<int>(io.DisplaySize.x * io.DisplayFramebufferScale.x)));
    const float x_px = column / (io.DisplayFramebufferScale.x > 0.0F ? io.DisplayFramebufferScale.x : 1.0F);
    const bool over = !io.WantCaptureMouse && isOnDivider(static_cast<double>(io.MousePos.x) + 0.5,
                                                          choice.divider, static_cast<int>(io.DisplaySize.x));
    drawDivider(x_px, held || over);
    drawPlate(nameOf(choice.method), x_px - plateGap_px, 1.0F);
    drawPlate(nameOf(choice.other), x_px + plateGap_px, 0.0F);
    if (held || over)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

} // namespace dioptre
