#include "render/planner.h"
#include "render/shared_values.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// "2 objects" of a shape for which `holds`, "" where there is none.
template <typename Shape>
std::string countOf(
    const Scene& scene, const std::function<bool(const Shape&)>& holds = [](const Shape&) { return true; })
{
    const auto count = std::count_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
        const auto* shape = std::get_if<Shape>(&object.primitive);
        return shape != nullptr && holds(*shape);
    });
    return count == 0 ? "" : fmt::format("{} object{}", count, count == 1 ? "" : "s");
}

} // namespace

std::string countedNames(const std::vector<std::string>& names, const std::string& what)
{
    constexpr std::size_t shown = 3;
    const std::vector<std::string> first(names.begin(),
                                         names.begin() + static_cast<long>(std::min(shown, names.size())));
    return fmt::format("{} {}{}: {}{}", names.size(), what, names.size() == 1 ? "" : "s", join(first, ", "),
                       names.size() > shown ? ", …" : "");
}

Plan Planner::make()
{
    findUsed();
    view();
    shapes();
    const bool noLight = plan_.view != DataView::none;
    addUnderView(&Planner::surfaces, noLight);
    addUnderView(&Planner::rays, showsFirstHit(plan_.view));
    addUnderView(&Planner::lights, noLight);
    addUnderView(&Planner::sky, noLight);
    longitudes();
    within();
    kernels();
    form();
    animation();
    gatherDefines();
    values();
    gatherDefines();
    return std::move(plan_);
}

void Planner::view()
{
    const auto view = plan_.view;
    std::vector<std::string> defines;
    if (view == DataView::object || view == DataView::number)
        defines = {"HAS_OBJECT_VIEW"};
    if (view == DataView::depth)
        defines = {"HAS_DEPTH_VIEW"};
    if (view == DataView::normal)
        defines = {"HAS_SURFACE_VIEW", "HAS_NORMAL_VIEW"};
    if (view == DataView::uv)
        defines = {"HAS_SURFACE_VIEW", "HAS_UV_VIEW", "HAS_COORDINATES"};
    if (view == DataView::rays || view == DataView::lost)
        defines = {"HAS_LOST_WEIGHT"};
    if (view == DataView::trust)
        defines = {"HAS_TRUST"};
    const bool in = view != DataView::none;
    add("view", in, in ? std::string(rowOf(view).name) + ": " + rowOf(view).shows : "", "light is shown",
        std::move(defines));
}

void Planner::addUnderView(void (Planner::*rows)(), bool byView)
{
    auto next = plan_.features.size();
    (this->*rows)();
    for (; byView && next < plan_.features.size(); ++next)
        if (!plan_.features[next].in)
            plan_.features[next].reason = "the view asks for none";
}

void Planner::gatherDefines()
{
    for (const auto& feature : plan_.features)
        if (feature.in)
            plan_.defines.insert(feature.defines.begin(), feature.defines.end());
}

void Planner::add(const std::string& name, bool in, const std::string& whyIn, const std::string& whyOut,
                  std::vector<std::string> defines)
{
    const bool forced = !in && canForce(name, defines);
    plan_.features.push_back({name, in || forced,
                              in       ? whyIn
                              : forced ? "plan.force is all"
                                       : whyOut,
                              std::move(defines)});
}

// What plan.force = "all" brings in: every part that the scene's data can switch off again. The forms that
// the scene takes exclude each other, a tree of one ray sends none on, and an empty scene or one without
// lights has no tables to ask.
bool Planner::canForce(const std::string& name, const std::vector<std::string>& defines) const
{
    static const std::set<std::string> forms = {"light loops",
                                                "shared view",
                                                "shared lights",
                                                "shared materials",
                                                "moving geometry",
                                                "tinted shadows",
                                                "arctangent by polynomial",
                                                "compensated kernels",
                                                "kernels by curvature"};
    if (scene_.plan.force != PlanChoices::Force::all || plan_.view != DataView::none ||
        scene_.objects.empty() || defines.empty() || forms.contains(name))
        return false;
    static const std::set<std::string> ofLights = {
        "HAS_LIGHTS",         "HAS_HIGHLIGHT",         "HAS_SHADOWS",
        "HAS_TINTED_SHADOWS", "HAS_SHADOW_ABSORPTION", "HAS_LIGHT_AMBIENT"};
    const bool dark = plan_.placedLights.empty() && plan_.glowing.empty();
    if (dark && std::ranges::any_of(defines, [&](const auto& define) { return ofLights.contains(define); }))
        return false;
    return name != "depth limit" || scene_.trace.budget.value_or(2) > 1;
}

std::string Planner::materialsWith(const std::function<bool(const Material&)>& holds) const
{
    std::vector<std::string> names;
    for (const auto i : plan_.materials)
        if (holds(scene_.materials[i]))
            names.push_back(scene_.materials[i].name);
    return join(names, ", ");
}

void Planner::addForMaterials(const std::string& name, const std::function<bool(const Material&)>& holds,
                              const std::string& whyOut, std::vector<std::string> defines)
{
    const auto names = materialsWith(holds);
    add(name, !names.empty(), "material " + names, whyOut, std::move(defines));
}

void Planner::findUsed()
{
    std::set<std::size_t> used;
    onObject_.assign(scene_.materials.size(), false);
    isSeen_.assign(scene_.materials.size(), false);
    for (std::size_t id = 0; id < scene_.objects.size(); ++id) {
        const std::size_t material = scene_.objects[id].material;
        used.insert(material);
        onObject_[material] = true;
        isSeen_[material] = isSeen_[material] || plan_.seen[id];
    }
    if (scene_.camera.inside)
        used.insert(*scene_.camera.inside);
    // The media outside of used materials matter to absorption, and those outside of these.
    for (const auto i : std::set<std::size_t>(used))
        for (auto outside = scene_.materials[i].outside; outside && used.insert(*outside).second;)
            outside = scene_.materials[*outside].outside;
    plan_.materials = {used.begin(), used.end()};
    for (const auto i : plan_.materials)
        plan_.seenMaterials.push_back(isSeen(scene_.materials[i]));
    for (std::size_t i = 0; i < scene_.objects.size(); ++i)
        if (scene_.materials[scene_.objects[i].material].light)
            plan_.glowing.push_back(i);
    for (std::size_t i = 0; i < scene_.lights.size(); ++i)
        if (scene_.lights[i].kind != Light::Kind::ambient)
            plan_.placedLights.push_back(i);
    std::ranges::stable_sort(plan_.placedLights, {}, [this](auto i) { return scene_.lights[i].kind; });
}

void Planner::addForShape(const std::string& name, const std::string& count, std::vector<std::string> defines)
{
    add(name, !count.empty(), count, "no such object", std::move(defines));
}

void Planner::shapes()
{
    add("objects", !seesNothing(), fmt::format("{} in all", std::ranges::count(plan_.seen, true)),
        scene_.objects.empty() ? "the scene is empty" : "none is seen", {"HAS_OBJECTS"});
    addForShape("sphere", countOf<Sphere>(scene_), {"HAS_SPHERE", "HAS_ROUND_SHAPE"});
    addForShape("open cylinder", countOf<Cylinder>(scene_, [](const auto& c) { return !c.capped; }),
                {"HAS_CYLINDER", "HAS_OPEN_CYLINDER", "HAS_ROUND_SHAPE"});
    addForShape("capped cylinder", countOf<Cylinder>(scene_, [](const auto& c) { return c.capped; }),
                {"HAS_CYLINDER", "HAS_CAPPED_CYLINDER", "HAS_ROUND_SHAPE"});
    addForShape("plane", countOf<Plane>(scene_), {"HAS_PLANE", "HAS_FLAT"});
    addForShape("disk", countOf<Disk>(scene_), {"HAS_DISK", "HAS_FLAT"});
    addForShape("rectangle", countOf<Rectangle>(scene_), {"HAS_RECTANGLE", "HAS_FLAT"});
    addForShape("triangle", countOf<Triangle>(scene_), {"HAS_TRIANGLE", "HAS_FLAT"});
}

bool seesDirections(const Plan& plan)
{
    if (plan.view == DataView::rays || plan.view == DataView::lost)
        return plan.tree != RayTree::single;
    return plan.has("objects") || plan.has("sky gradient") || plan.has("sky picture");
}

void Planner::longitudes()
{
    const bool asked =
        plan_.has("sphere coordinates") || plan_.has("cylinder coordinates") || plan_.has("sky picture");
    add("arctangent by polynomial", asked && scene_.plan.arctangent == PlanChoices::Arctangent::automatic,
        "cheaper than the driver's own", asked ? "plan.arctangent is built-in" : "no longitude is asked for",
        {"HAS_ARCTANGENT_POLYNOMIAL"});
}

void Planner::animation()
{
    const auto moving = scene_.moving.size();
    const bool literal = plan_.form == SceneForm::literal;
    add("animation", !scene_.animated.empty(), countedNames(scene_.animated, "value"),
        "nothing changes with time", {});
    add("moving geometry", moving > 0 && (literal || plan_.movesApart),
        fmt::format("{} object{}: geometry as uniforms", moving, moving == 1 ? "" : "s"),
        moving == 0 ? "no object moves" : "trace.form is loop: all geometry is in the table", {});
}

const Feature& Plan::feature(const std::string& name) const
{
    const auto found =
        std::find_if(features.begin(), features.end(), [&](const Feature& f) { return f.name == name; });
    if (found == features.end())
        throw std::logic_error("the plan has no feature called " + name);
    return *found;
}

Plan makePlan(const Scene& scene, DataView view)
{
    return makePlan(scene, view, ShaderDevice());
}

Plan makePlan(const Scene& scene, DataView view, const ShaderDevice& device, std::vector<bool> seen)
{
    return Planner(scene, view, device, std::move(seen)).make();
}

} // namespace dioptre
