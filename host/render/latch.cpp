#include "render/latch.h"

#include "render/kernel_choice.h"
#include "render/pack.h"
#include "render/within.h"

#include <algorithm>
#include <numeric>

namespace dioptre
{
namespace
{

bool sameKind(const Material& a, const Material& b)
{
    const bool castA = a.shadow != ShadowKind::none;
    const bool castB = b.shadow != ShadowKind::none;
    return a.name == b.name && a.image == b.image && a.encoding == b.encoding &&
           a.checker.has_value() == b.checker.has_value() && a.model == b.model && a.outside == b.outside &&
           a.light == b.light && castA == castB;
}

bool sameKind(const Light& a, const Light& b)
{
    return a.kind == b.kind;
}

bool sameKind(const Object& a, const Object& b)
{
    return a.primitive.index() == b.primitive.index() && isSolid(a.primitive) == isSolid(b.primitive) &&
           a.material == b.material;
}

template <typename Thing>
bool sameKinds(const std::vector<Thing>& a, const std::vector<Thing>& b)
{
    return std::ranges::equal(a, b, [](const Thing& x, const Thing& y) { return sameKind(x, y); });
}

bool sameStructure(const Scene& a, const Scene& b)
{
    return sameKinds(a.materials, b.materials) && sameKinds(a.lights, b.lights) &&
           sameKinds(a.objects, b.objects) && a.camera.inside == b.camera.inside &&
           a.sky.kind == b.sky.kind && a.trace.order == b.trace.order && a.trace.form == b.trace.form &&
           a.trace.lightType == b.trace.lightType && a.plan == b.plan && a.animated == b.animated &&
           a.moving == b.moving;
}

// The following are 0, or a share 1, only where both are. No means: those of a long chain of edits would run
// down to 0.
double latchedShare(double now, double before)
{
    return now == before ? now : 0.5;
}

glm::dvec3 latchedAmount(const glm::dvec3& now, const glm::dvec3& before)
{
    return before == glm::dvec3(0.0) ? now : before;
}

void latchMaterial(Material& now, const Material& before)
{
    now.mirror = latchedShare(now.mirror, before.mirror);
    now.transmit = latchedShare(now.transmit, before.transmit);
    now.specular = latchedAmount(now.specular, before.specular);
    now.absorption = latchedAmount(now.absorption, before.absorption);
    now.emission = latchedAmount(now.emission, before.emission);
    now.ambient = before.ambient ? before.ambient : now.ambient;
    // By default a material that is clear at times alone is opaque at the others.
    now.shadow = before.shadow == ShadowKind::tinted ? before.shadow : now.shadow;
}

// Unset only where both are: the default grows with the materials'.
std::optional<int> latchedBudget(const Scene& now, const Scene& before)
{
    if (!now.trace.budget && !before.trace.budget)
        return std::nullopt;
    std::vector<std::size_t> all(now.materials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return std::max(now.trace.budget.value_or(defaultBudget(now, all)),
                    before.trace.budget.value_or(defaultBudget(before, all)));
}

// Whether the eye is within an opaque solid that the eye of the plan is not in.
bool entersSolid(const Scene& planned, const glm::dvec3& eye)
{
    return std::ranges::any_of(planned.objects, [&](const Object& object) {
        return isSolid(object.primitive) && planned.materials[object.material].transmit == 0.0 &&
               isOutside(object.primitive, planned.camera.eye) && !isOutside(object.primitive, eye);
    });
}

} // namespace

void latch(Scene& scene, const Scene& before)
{
    if (!sameStructure(scene, before))
        return;
    Scene own = ownTypicalOf(scene);
    own.typical.clear();
    Scene latched = typicalOf(scene);
    latched.typical.clear();
    const Scene& earlier = typicalOf(before);
    for (std::size_t i = 0; i < latched.materials.size(); ++i)
        latchMaterial(latched.materials[i], earlier.materials[i]);
    for (std::size_t i = 0; i < latched.lights.size(); ++i)
        latched.lights[i].ambient = latchedAmount(latched.lights[i].ambient, earlier.lights[i].ambient);
    latched.trace.budget = latchedBudget(latched, earlier);
    latched.trace.depth = latched.trace.depth ? latched.trace.depth : earlier.trace.depth;
    if (originServes(sceneOrigin(earlier), own.camera))
        latched.camera = earlier.camera;
    addSights(latched, earlier.sights);
    addSights(latched, {sightOf(earlier, earlier.camera), sightOf(scene, scene.camera)});
    if (earlier.plan.within == PlanChoices::Within::always || entersSolid(latched, scene.camera.eye))
        latched.plan.within = PlanChoices::Within::always;
    scene.typical = {std::move(latched), std::move(own)};
}

} // namespace dioptre
