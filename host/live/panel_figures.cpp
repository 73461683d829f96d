#include "live/panel_figures.h"

#include "live/panel_widgets.h"
#include "render/data_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

namespace dioptre
{
namespace
{

const ImVec4 alarmText(1.0F, 0.4F, 0.35F, 1.0F);
const ImVec4 busyText(0.55F, 0.8F, 1.0F, 1.0F);
constexpr double longCompile_s = 0.2;
constexpr float planColumn = 0.5F;          // of the panel's width, where reasons begin
constexpr std::size_t mostLegendLines = 12; // at once

std::string milliseconds(double ms)
{
    return ms >= 1000.0 ? fmt::format("{:.2f} s", ms / 1000.0) : fmt::format("{:.1f} ms", ms);
}

void drawFrameTimes(const std::deque<float>& frames_ms)
{
    if (frames_ms.empty())
        return;
    const std::vector<float> times(frames_ms.begin(), frames_ms.end());
    std::vector<float> sorted = times;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const float median = *middle;
    // A pause between two pictures is no frame's time: it would flatten the graph.
    const float top = std::max(3.0F * median, 1.0F);
    ImGui::PlotLines("##frames", times.data(), static_cast<int>(times.size()), 0,
                     fmt::format("frame {:.1f} ms, median {:.1f}", static_cast<double>(times.back()),
                                 static_cast<double>(median))
                         .c_str(),
                     0.0F, top, {ImGui::GetContentRegionAvail().x, 3.0F * ImGui::GetFontSize()});
}

void drawLost(const std::array<double, 4>& lost)
{
    if (lost[0] + lost[1] + lost[2] <= 0.0)
        return;
    drawFact("lost weight",
             fmt::format("cut-off {:.2g}  pool {:.2g}  budget {:.2g}", lost[0], lost[1], lost[2]));
}

void drawMethod(const MethodFacts& facts, bool named)
{
    drawFact(named ? nameOf(facts.method) : "a sample",
             milliseconds(facts.sample_ms) + (named ? " a sample" : ""));
    if (!facts.raster)
        return;
    drawFact("  objects", fmt::format("{} drawn, {} culled", facts.raster->drawn, facts.raster->culled));
    drawFact("  triangles", std::to_string(facts.raster->triangles));
    if (facts.raster->shadowMaps > 0)
        drawFact("  shadow maps",
                 fmt::format("{} of {} px", facts.raster->shadowMaps, facts.raster->shadowMap_px));
}

void drawPicture(const LiveModel& model, const UiFacts& facts)
{
    const StageFacts& stage = facts.stage.facts();
    drawFrameTimes(facts.frames_ms);
    for (const MethodFacts& each : stage.methods)
        drawMethod(each, stage.methods.size() > 1 || isRasterised(each.method));
    if (stage.raysPerPixel && facts.stage.loaded()->scene)
        drawFact("rays a sample", fmt::format("{:.3f}", *stage.raysPerPixel));
    drawLost(model.lost);
    if (stage.nonfinite > 0)
        ImGui::TextColored(alarmText, "%zu pixels are not finite", stage.nonfinite);
    const glm::ivec2 size_px = facts.stage.size_px();
    drawFact("size", fmt::format("{} x {}", size_px.x, size_px.y));
    drawFact("drawn by", facts.context.renderer);
}

void drawReload(const ReloadFigures& reload)
{
    drawFact("reload", milliseconds(reload.total_ms));
    const bool compiled = reload.compile_ms > 0.0;
    drawFact("  load", milliseconds(reload.load_ms));
    drawFact("  compile", compiled ? milliseconds(reload.compile_ms) : "not needed");
    drawFact("  window", milliseconds(reload.window_ms));
    if (compiled && !reload.keptByDriver) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextWrapped("this driver keeps no compiled shaders: the window compiled it again");
        ImGui::PopStyleColor();
    }
}

void drawPlan(const Plan& plan)
{
    for (const bool in : {true, false}) {
        const auto count =
            std::ranges::count_if(plan.features, [&](const Feature& feature) { return feature.in == in; });
        if (!ImGui::TreeNodeEx(in ? "in" : "out", in ? ImGuiTreeNodeFlags_DefaultOpen : 0, "%s: %d parts",
                               in ? "in the shader" : "left out", static_cast<int>(count)))
            continue;
        for (const Feature& feature : plan.features)
            if (feature.in == in)
                drawFactAt(planColumn * ImGui::GetWindowContentRegionMax().x, feature.name, feature.reason);
        ImGui::TreePop();
    }
}

// Of what is on the left.
const Plan& planShown(const LoadedScene& scene)
{
    return scene.rasters.front() ? scene.rasters.front()->scene.prepared.plan : scene.prepared.plan;
}

// Files that would come first if they were there are watched, but do not feed the picture.
void drawSources(const std::vector<std::filesystem::path>& files)
{
    std::error_code error;
    for (const auto& file : files) {
        if (!std::filesystem::exists(file, error))
            continue;
        ImGui::TextUnformatted(elided(file.filename().string(), ImGui::GetContentRegionAvail().x).c_str());
        drawHint(file.string());
    }
}

// "#rrggbb  what it means" with the colour itself, and other lines as they are.
void drawLegendLine(const std::string& line)
{
    constexpr std::size_t digits = 7; // with the "#"
    unsigned rgb = 0;
    const bool coloured =
        line.size() > digits && line.front() == '#' &&
        std::from_chars(line.data() + 1, line.data() + digits, rgb, 16).ptr == line.data() + digits;
    if (!coloured)
        return ImGui::TextWrapped("%s", line.c_str());
    const float side_px = ImGui::GetTextLineHeight();
    const auto channel = [&](unsigned shift) { return static_cast<float>((rgb >> shift) & 0xFFU) / 255.0F; };
    ImGui::ColorButton(line.c_str(), {channel(16), channel(8), channel(0), 1.0F},
                       ImGuiColorEditFlags_NoTooltip, {side_px, side_px});
    ImGui::SameLine();
    ImGui::TextUnformatted(line.c_str() + digits);
}

} // namespace

// One line at all times: what came and went above the rows would move them under the hand.
void drawState(const LiveModel& model, const UiFacts& facts)
{
    const Loaded* const loaded = facts.stage.loaded();
    if (facts.compilingFor_s > longCompile_s)
        return ImGui::TextColored(busyText, "compiling\u2026 %.1f s", facts.compilingFor_s);
    if (loaded == nullptr)
        return ImGui::TextDisabled("%s", model.fault ? "no picture yet" : "loading\u2026");
    const bool isTitled = loaded->scene && !loaded->scene->scene->title.empty();
    const std::string text = isTitled ? loaded->scene->scene->title : model.look.input.path.string();
    ImGui::TextDisabled("%s", elided(text, ImGui::GetContentRegionAvail().x).c_str());
    drawHint(text);
}

void drawLegend(const UiFacts& facts)
{
    const Loaded& loaded = *facts.stage.loaded();
    if (loaded.view.view == DataView::none)
        return;
    drawFact("view", std::string(rowOf(loaded.view.view).name));
    if (!facts.stage.facts().legend)
        return;
    const auto& lines = facts.stage.facts().legend->lines;
    const bool scrolls = lines.size() > mostLegendLines;
    if (scrolls)
        ImGui::BeginChild("legend", {0.0F, mostLegendLines * ImGui::GetTextLineHeightWithSpacing()});
    for (const std::string& line : lines)
        drawLegendLine(line);
    if (scrolls)
        ImGui::EndChild();
}

void drawFigures(const LiveModel& model, const UiFacts& facts)
{
    const Loaded& loaded = *facts.stage.loaded();
    if (ImGui::CollapsingHeader("Figures", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawPicture(model, facts);
        drawReload(model.reload);
    }
    if (loaded.scene && ImGui::CollapsingHeader("Plan"))
        drawPlan(planShown(*loaded.scene));
    if (ImGui::CollapsingHeader("Sources"))
        drawSources(loaded.files);
}

} // namespace dioptre
