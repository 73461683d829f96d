#include "render/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// "ground (1.5 pixels)".
std::string roundingOf(const Scene& scene, std::size_t id, const KernelChoice& choice)
{
    const std::string& own = scene.objects[id].name;
    const std::string name = own.empty() ? fmt::format("object {}", id) : own;
    return std::isfinite(choice.rounding_px) ? fmt::format("{} ({:.2g} pixels)", name, choice.rounding_px)
                                             : fmt::format("{} (the eye is upon it)", name);
}

} // namespace

// Whether any ray asks where it meets an object: one to a light may, where it is not seen.
bool Planner::isAsked(std::size_t id) const
{
    const Material& material = scene_.materials[scene_.objects[id].material];
    return plan_.seen[id] || (plan_.has("shadows") && material.shadow != ShadowKind::none);
}

// Objects that the plain kernels would round too coarsely. Where compensation cannot be had they keep the
// plain ones.
void Planner::kernels()
{
    const auto choices = chooseKernels(scene_);
    plan_.kernels.resize(choices.size());
    std::vector<std::string> compensated, curved;
    double most_px = 0.0;
    for (std::size_t id = 0; id < choices.size(); ++id) {
        if (!isAsked(id))
            continue;
        const bool moves = std::ranges::count(scene_.moving, id) > 0;
        KernelForm form = choices[id].form;
        // The surface point of an object that moves would have to move with it: compensation serves there.
        if (moves && form == KernelForm::curved)
            form = KernelForm::compensated;
        plan_.kernels[id] =
            form == KernelForm::compensated && guard_ == Guard::none ? KernelForm::plain : form;
        plan_.readsFine = plan_.readsFine || (moves && plan_.kernels[id] != KernelForm::plain);
        plan_.movesApart = plan_.movesApart || (moves && form != KernelForm::plain);
        if (form == KernelForm::plain)
            most_px = std::max(most_px, choices[id].rounding_px);
        else
            (form == KernelForm::curved ? curved : compensated)
                .push_back(roundingOf(scene_, id, choices[id]));
    }
    const std::string off = scene_.plan.kernels == PlanChoices::Kernels::plain ? "plan.kernels is plain" : "";
    const std::string small = fmt::format("rounding stays below {:.2g} pixels", most_px);
    const std::string guard =
        guard_ == Guard::none ? ", but this driver's sums are not exact: plain ones" : "";
    add("compensated kernels", !compensated.empty(), countedNames(compensated, "object") + guard,
        off.empty() ? small : off, {"HAS_CHOSEN_KERNELS"});
    add("kernels by curvature", !curved.empty(), countedNames(curved, "object"),
        off.empty() ? "no radius is over 1e4 times the way to it" : off, {"HAS_CHOSEN_KERNELS"});
    if (!compensated.empty() || !curved.empty()) {
        plan_.guard = guard_;
        if (guard_ == Guard::precise)
            plan_.defines.insert("HAS_PRECISE");
        if (guard_ == Guard::unit)
            plan_.defines.insert("HAS_UNIT");
    }
}

} // namespace dioptre
