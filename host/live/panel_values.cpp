#include "live/panel_values.h"

#include "live/panel_method_rows.h"
#include "live/panel_output_rows.h"
#include "live/panel_scene_rows.h"
#include "live/panel_shader_rows.h"
#include "live/panel_widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace dioptre
{
namespace
{

bool isChanged(const std::map<std::string, std::string>& changes, const std::string& path)
{
    return std::ranges::any_of(changes, [&](const auto& change) { return overlap(change.first, path); });
}

// A change of a part of a value, or of what it is a part of, would be applied before or after it.
void dropOverlapping(const LiveModel& model, const std::string& path, bool itself, UiWishes& wishes)
{
    for (const auto& [other, value] : model.changes)
        if (overlap(other, path) && (itself || other != path))
            wishes.dropped.push_back(other);
}

// The numbers that the user wants, as long as they are wanted: the picture may be some frames behind.
void showPending(PanelRow& row, const LiveModel& model, PanelState& state)
{
    const auto pending = state.pending.find(row.path);
    if (pending == state.pending.end())
        return;
    const auto change = model.changes.find(row.path);
    if (change != model.changes.end() && change->second == pending->second.value &&
        pending->second.numbers.size() == row.numbers.size()) {
        row.numbers = pending->second.numbers;
        row.unset.clear();
    } else {
        state.pending.erase(pending);
    }
}

void drawSceneValues(const LiveModel& model, const LoadedScene& loaded, PanelState& state, UiWishes& wishes)
{
    std::vector<PanelRow> rows = sceneRows(*loaded.scene, loaded.prepared.plan.budget);
    for (PanelRow& row : rows)
        showPending(row, model, state);
    const auto changed = [&](const PanelRow& row) { return isChanged(model.changes, row.path); };
    drawRows(rows, changed, [&](const PanelRow& row) {
        const RowDeed deed = drawRow(row, changed(row));
        if (deed.numbers && *deed.numbers != row.numbers) {
            const std::string value = tomlOf(row, *deed.numbers);
            dropOverlapping(model, row.path, false, wishes);
            wishes.changes[row.path] = value;
            state.pending[row.path] = {value, *deed.numbers};
        }
        if (deed.putBack)
            dropOverlapping(model, row.path, true, wishes);
    });
}

void drawCamera(const LiveModel& model, const Loaded& loaded, UiWishes& wishes)
{
    if (!ImGui::CollapsingHeader("Camera", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    Camera camera = cameraOf(model, loaded);
    const PanelRow row{.path = "camera.fov_y_deg",
                       .label = "fov, deg",
                       .numbers = {camera.fovY_deg},
                       .low = 1.0,
                       .high = 170.0,
                       .meaning = "vertical field of view; the wheel changes it too"};
    const bool moved = model.look.camera.has_value();
    const RowDeed deed = drawRow(row, moved);
    if (deed.numbers) {
        camera.fovY_deg = deed.numbers->front();
        wishes.camera = camera;
    }
    if (deed.putBack)
        wishes.actions.push_back(Action::resetCamera);
    const auto place = [](const glm::dvec3& v) {
        return fmt::format("{:.3g}, {:.3g}, {:.3g}", v.x, v.y, v.z);
    };
    drawFact("eye, m", place(camera.eye));
    drawFact("target, m", place(camera.target));
}

void drawOutput(const LiveModel& model, const LoadedScene& loaded, UiWishes& wishes)
{
    const Display& own = loaded.scene->output;
    const Display display = model.display.value_or(own);
    std::vector<PanelRow> rows = outputRows(display);
    for (PanelRow& row : rows)
        row.hasEffect = model.look.view == DataView::none;
    const auto changed = [&](const PanelRow& row) { return differs(display, own, row); };
    drawRows(rows, changed, [&](const PanelRow& row) {
        const RowDeed deed = drawRow(row, changed(row));
        if (deed.numbers && *deed.numbers != row.numbers)
            wishes.display = withOutput(display, row, *deed.numbers);
        if (!deed.putBack)
            return;
        const Display back = withOutputOf(own, row, display);
        wishes.display = overridesOf(back, own).empty() ? std::nullopt : std::optional(back);
    });
}

void drawMethods(const MethodChoice& choice, UiWishes& wishes)
{
    const auto unchanged = [](const PanelRow&) { return false; };
    drawRows(methodRows(choice), unchanged, [&](const PanelRow& row) {
        const RowDeed deed = drawRow(row, false);
        if (deed.numbers && *deed.numbers != row.numbers)
            wishes.methods = withMethod(choice, row, *deed.numbers);
    });
}

void drawShaderValues(const LiveModel& model, const Loaded& loaded, const StageFacts& stage,
                      PanelState& state, UiWishes& wishes)
{
    if (state.annotated != loaded.request.number) {
        state.annotated = loaded.request.number;
        state.annotations = annotationsOf(loaded.plain->text.text);
    }
    const auto& sliders = model.frame.live.sliders;
    const auto rows = shaderRows(state.annotations, stage.uniforms, loaded.request.look.values, sliders);
    const auto changed = [&](const PanelRow& row) { return sliders.contains(row.path); };
    drawRows(rows, changed, [&](const PanelRow& row) {
        const RowDeed deed = drawRow(row, changed(row));
        if (deed.numbers && *deed.numbers != row.numbers)
            wishes.sliders[row.path] = *deed.numbers;
        if (deed.putBack)
            wishes.dropped.push_back(row.path);
    });
}

} // namespace

void drawValues(const LiveModel& model, const Loaded& loaded, const StageFacts& stage, PanelState& state,
                UiWishes& wishes)
{
    if (loaded.plain)
        return drawShaderValues(model, loaded, stage, state, wishes);
    drawMethods(model.methods, wishes);
    drawSceneValues(model, *loaded.scene, state, wishes);
    drawCamera(model, loaded, wishes);
    drawOutput(model, *loaded.scene, wishes);
}

} // namespace dioptre
