#include "render/planner.h"

#include "scene/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace dioptre
{
namespace
{

// Where a shape stands among the alternatives of Primitive.
template <typename Shape>
const std::size_t indexOf = Primitive(Shape{}).index();

std::string nameOf(TreeOrder order)
{
    return std::string(std::ranges::find(treeOrders, order, &NamedChoice<TreeOrder>::choice)->name);
}

// How many interfaces lie within each other: the longest chain of `outside`, counted from air.
int nestingOf(const Scene& scene, const std::vector<std::size_t>& materials)
{
    int deepest = 0;
    for (const auto i : materials) {
        int depth = 0;
        std::optional<std::size_t> medium = i;
        while (medium && scene.materials[*medium].transmit > 0.0) {
            ++depth;
            medium = scene.materials[*medium].outside;
        }
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

} // namespace

bool wears(const Material& material)
{
    return !material.image.empty() || material.checker.has_value();
}

bool canShine(const Material& material)
{
    return material.specular != glm::dvec3(0.0) || material.model == ReflectanceModel::microfacet;
}

bool Planner::onObject(const Material& material) const
{
    return onObject_[static_cast<std::size_t>(&material - scene_.materials.data())];
}

bool Planner::isSeen(const Material& material) const
{
    return isSeen_[static_cast<std::size_t>(&material - scene_.materials.data())];
}

bool Planner::seesNothing() const
{
    return std::ranges::count(plan_.seen, true) == 0;
}

bool Planner::hasLocal(const Material& material)
{
    return material.mirror < 1.0 && material.transmit < 1.0;
}

bool Planner::anythingShines() const
{
    const bool everywhere = std::ranges::any_of(
        scene_.lights, [](const Light& light) { return light.ambient != glm::dvec3(0.0); });
    return everywhere || !plan_.placedLights.empty() || !plan_.glowing.empty();
}

void Planner::surfaces()
{
    const bool lit = anythingShines();
    const auto shows = [this, lit](const Material& m) { return lit && isSeen(m) && hasLocal(m); };
    addForMaterials("picture", [&](const auto& m) { return shows(m) && !m.image.empty(); },
                    "no lit material has an image", {"HAS_PICTURES", "HAS_COORDINATES"});
    addForMaterials("checker", [&](const auto& m) { return shows(m) && m.checker; },
                    "no lit material has a pattern", {"HAS_CHECKER", "HAS_COORDINATES"});
    addForMaterials("emission", [&](const auto& m) { return isSeen(m) && m.emission != glm::dvec3(0.0); },
                    "no material glows", {"HAS_EMISSION"});
    const bool shown = plan_.view == DataView::uv;
    coordinates([&](const Material& m) { return shown || (shows(m) && wears(m)); });
    pictures();
}

void Planner::pictures()
{
    for (const auto i : plan_.materials) {
        const auto& material = scene_.materials[i];
        const PictureUse use{material.image, material.encoding};
        if (anythingShines() && onObject(material) && hasLocal(material) && !material.image.empty() &&
            std::ranges::count(plan_.pictures, use) == 0)
            plan_.pictures.push_back(use);
    }
    plan_.padPictures = scene_.plan.pictures != PlanChoices::Pictures::apart;
    plan_.pictureRepeats.resize(plan_.pictures.size() + 1);
    plan_.sampled.resize(plan_.pictures.size() + 1, plan_.pictures.empty());
    for (std::size_t id = 0; id < scene_.objects.size(); ++id) {
        const auto& object = scene_.objects[id];
        const auto& material = scene_.materials[object.material];
        const auto found = std::ranges::find(plan_.pictures, PictureUse{material.image, material.encoding});
        if (found == plan_.pictures.end())
            continue;
        const auto picture = static_cast<std::size_t>(found - plan_.pictures.begin());
        plan_.sampled[picture] = plan_.sampled[picture] || plan_.seen[id];
        auto& repeats = plan_.pictureRepeats[picture];
        const bool plane = std::holds_alternative<Plane>(object.primitive);
        repeats.u = repeats.u || plane || std::holds_alternative<Sphere>(object.primitive) ||
                    std::holds_alternative<Cylinder>(object.primitive);
        repeats.v = repeats.v || plane;
    }
}

void Planner::coordinates(const std::function<bool(const Material&)>& wears)
{
    const std::tuple<const char*, std::size_t, const char*> kinds[] = {
        {"plane coordinates", indexOf<Plane>, "HAS_PLANE_COORDINATES"},
        {"sphere coordinates", indexOf<Sphere>, "HAS_SPHERE_COORDINATES"},
        {"cylinder coordinates", indexOf<Cylinder>, "HAS_CYLINDER_COORDINATES"},
        {"disk coordinates", indexOf<Disk>, "HAS_DISK_COORDINATES"},
        {"rectangle coordinates", indexOf<Rectangle>, "HAS_RECTANGLE_COORDINATES"},
        {"triangle coordinates", indexOf<Triangle>, "HAS_TRIANGLE_COORDINATES"}};
    for (const auto& [name, kind, define] : kinds) {
        std::size_t count = 0;
        for (std::size_t id = 0; id < scene_.objects.size(); ++id) {
            const auto& object = scene_.objects[id];
            const bool wearing = object.primitive.index() == kind && wears(scene_.materials[object.material]);
            count += plan_.seen[id] && wearing ? 1 : 0;
        }
        add(name, count > 0,
            plan_.view == DataView::uv
                ? "the view shows them"
                : fmt::format("{} of them wear{} a picture or a pattern", count, count == 1 ? "s" : ""),
            "none of them wears a picture or a pattern", {define});
    }
}

void Planner::rays()
{
    addForMaterials("mirror", [&](const auto& m) { return isSeen(m) && m.mirror > 0.0; },
                    "no material mirrors", {"HAS_MIRROR_RAY"});
    const auto clear =
        materialsWith([&](const auto& m) { return isSeen(m) && m.transmit > 0.0 && m.mirror < 1.0; });
    add("refraction", !clear.empty() || poolAlways(),
        clear.empty() ? "plan.pool is always" : "material " + clear, "no material transmits light",
        {"HAS_MIRROR_RAY", "HAS_REFRACTION"});
    const bool refracts = plan_.has("refraction");
    const bool swims = scene_.camera.inside.has_value();
    const auto absorbing = materialsWith([](const auto& m) { return m.absorption != glm::dvec3(0.0); });
    add("absorption", !absorbing.empty() && (refracts || swims), "material " + absorbing,
        absorbing.empty() ? "no medium absorbs" : "no ray gets into a medium", {"HAS_ABSORPTION"});
    // A view of the tree tells what a budget of one ray leaves out.
    const bool goesOn = scene_.trace.budget.value_or(2) > 1 || showsRayTree(plan_.view);
    const bool sendsOn = (refracts || plan_.has("mirror")) && goesOn;
    add("depth limit", sendsOn && scene_.trace.depth.has_value(), "trace.depth is set",
        sendsOn ? "trace.depth is not set" : "no ray is sent on", {"HAS_DEPTH_LIMIT"});
    rayTree(sendsOn, refracts);
}

// An empty scene, a first hit and a budget of one ray send none on; other orders have no pool.
bool Planner::poolAlways() const
{
    return scene_.plan.pool == PlanChoices::Pool::always && scene_.trace.order == TreeOrder::heaviestFirst &&
           !seesNothing() && !showsFirstHit(plan_.view) && scene_.trace.budget.value_or(2) > 1;
}

int defaultBudget(const Scene& scene, const std::vector<std::size_t>& materials)
{
    return 16 + 8 * std::max(0, nestingOf(scene, materials) - 1);
}

void Planner::rayTree(bool sendsOn, bool refracts)
{
    const int nested = nestingOf(scene_, plan_.materials);
    plan_.budget = sendsOn ? scene_.trace.budget.value_or(defaultBudget(scene_, plan_.materials)) : 1;
    plan_.poolSlots = nested > 1 || poolAlways() ? 4 : 3;
    const auto order = scene_.trace.order;
    plan_.tree = !sendsOn                           ? RayTree::single
                 : order == TreeOrder::breadthFirst ? RayTree::breadthFirst
                 : order == TreeOrder::depthFirst   ? RayTree::depthFirst
                 : refracts                         ? RayTree::heaviestFirst
                                                    : RayTree::chain;
    const std::string orderIs = std::string("trace.order is ") + nameOf(order);
    const std::string never = sendsOn ? "no surface both reflects and refracts" : "no ray is sent on";
    add("ray chain", plan_.tree == RayTree::chain, "surfaces send on one ray each",
        sendsOn ? "a surface splits rays, or trace.order asks for another tree" : "no ray is sent on", {});
    add("ray pool", plan_.tree == RayTree::heaviestFirst,
        fmt::format("{} slots: {}", plan_.poolSlots,
                    nested > 1     ? "media lie within each other"
                    : poolAlways() ? "plan.pool is always"
                                   : "surfaces reflect and refract"),
        order != TreeOrder::heaviestFirst && sendsOn ? orderIs : never, {});
    add("ray queue", plan_.tree == RayTree::breadthFirst, orderIs, sendsOn ? orderIs : never, {});
    add("ray stack", plan_.tree == RayTree::depthFirst, orderIs, sendsOn ? orderIs : never, {});
}

} // namespace dioptre
