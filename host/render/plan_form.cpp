#include "render/planner.h"

#include "render/shared_values.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

// Up to so many objects or materials a chain of selects is no slower than a gather from a table: even at the
// still life's 10, 14 % slower at the 12 of glass.
constexpr std::ptrdiff_t mostSelects = 10;

// Up to so many lights each has code of its own; beyond, one loop for each kind.
constexpr std::size_t mostLightsInLine = 4;

} // namespace

void Planner::form()
{
    using Lookup = PlanChoices::Lookup;
    plan_.form = scene_.trace.form;
    const bool literal = plan_.form == SceneForm::literal;
    const bool empty = seesNothing();
    const auto choices =
        std::max(std::ranges::count(plan_.seen, true), std::ranges::count(plan_.seenMaterials, true));
    plan_.lookup = !literal                                       ? Lookup::table
                   : plan_.view == DataView::trust                ? Lookup::table // asks for all of a shape
                   : scene_.plan.lookup != Lookup::automatic      ? scene_.plan.lookup
                   : scene_.plan.force == PlanChoices::Force::all ? Lookup::table
                   : choices <= mostSelects                       ? Lookup::selects
                                                                  : Lookup::table;
    // Which object a ray meets, and how far away, is known without a look at what it is.
    const bool asked = !literal || (plan_.view != DataView::object && plan_.view != DataView::number &&
                                    plan_.view != DataView::depth);
    const bool table = plan_.lookup == Lookup::table && !empty && asked;
    const std::string chosen = scene_.plan.lookup != Lookup::automatic        ? "plan.lookup"
                               : scene_.plan.force == PlanChoices::Force::all ? "plan.force is all"
                                                                              : "";
    add("literal geometry", literal, "geometry as constants", "trace.form is loop", {});
    add("surfaces by selects", !table && !empty && asked,
        chosen.empty() ? fmt::format("{} objects and materials at most", choices) : chosen,
        empty   ? "the scene is empty"
        : asked ? "they come from the table"
                : "the view does not ask for them",
        {});
    add("geometry table", table,
        !literal         ? "trace.form is loop"
        : chosen.empty() ? fmt::format("{} objects or materials", choices)
                         : chosen,
        literal ? "geometry is literal, surfaces by selects" : "the scene is empty", {});
}

// What each pixel reads of camera, sky, lights and materials: through the vertex stage as far as there is
// room.
void Planner::values()
{
    using Choice = PlanChoices::Values;
    const std::size_t lights = plan_.placedLights.size() + plan_.glowing.size();
    const bool shared = scene_.plan.values != Choice::uniforms;
    const bool inLine = lights > 0 && lights <= mostLightsInLine && plan_.form == SceneForm::literal;
    const auto fits = [&](const std::vector<SharedValue>& more) {
        auto all = plan_.shared;
        all.insert(all.end(), more.begin(), more.end());
        const bool room = vectorsOf(all) <= mostShared_;
        if (room)
            plan_.shared = std::move(all);
        return room;
    };
    if (shared)
        fits(sharedView(plan_));
    const std::string off = "plan.values is uniforms";
    add("light loops", lights > 0 && !inLine, fmt::format("{} lights", lights),
        lights == 0 ? "no light to reflect" : "each light has code of its own", {"HAS_LIGHT_LOOPS"});
    add("shared view", shared, "camera, sky and settings come through the vertex stage", off,
        {"HAS_SHARED_VIEW", "HAS_SHARED_VALUES"});
    const bool lightsShared = shared && inLine && fits(sharedLights(scene_, plan_));
    add("shared lights", lightsShared, "they come through the vertex stage",
        !shared       ? off
        : lights == 0 ? "no light to reflect"
        : inLine      ? "no room for them in the vertex stage's outputs"
                      : "loops read them from a block",
        {"HAS_SHARED_LIGHTS"});
    const bool known = plan_.lookup == PlanChoices::Lookup::selects && !seesNothing();
    const auto read = sharedMaterials(scene_, plan_);
    const bool asked = !showsFirstHit(plan_.view) || plan_.view == DataView::uv;
    plan_.readsMaterials = (plan_.has("geometry table") && asked) || !read.empty();
    std::size_t placed = 0;
    if (shared && known)
        for (const auto& value : read)
            placed += fits({value}) ? 1 : 0;
    add("shared materials", placed > 0,
        fmt::format("{} of {} values come through the vertex stage", placed, read.size()),
        !shared ? off
        : known ? "no room for them in the vertex stage's outputs"
                : "they are read by index",
        {"HAS_SHARED_MATERIALS"});
}

} // namespace dioptre
