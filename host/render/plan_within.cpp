#include "render/planner.h"
#include "render/within.h"

#include "scene/direction.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

bool outside(const Sphere& sphere, const glm::dvec3& eye)
{
    const double scale = sphere.radius + glm::length(sphere.centre) + glm::length(eye);
    return glm::distance(eye, sphere.centre) > sphere.radius + 1e-6 * scale;
}

bool outside(const Cylinder& cylinder, const glm::dvec3& eye)
{
    const glm::dvec3 axis = unit(cylinder.axis);
    const glm::dvec3 offset = eye - cylinder.base;
    const double along = glm::dot(offset, axis);
    const double height = glm::dot(cylinder.axis, axis);
    const double scale = cylinder.radius + height + glm::length(cylinder.base) + glm::length(eye);
    const double beyond =
        std::max({-along, along - height, glm::length(offset - along * axis) - cylinder.radius});
    return beyond > 1e-6 * scale;
}

} // namespace

bool isSolid(const Primitive& primitive)
{
    const auto* cylinder = std::get_if<Cylinder>(&primitive);
    return std::holds_alternative<Sphere>(primitive) || (cylinder != nullptr && cylinder->capped);
}

bool isOutside(const Primitive& solid, const glm::dvec3& eye)
{
    const auto* sphere = std::get_if<Sphere>(&solid);
    return sphere != nullptr ? outside(*sphere, eye) : outside(std::get<Cylinder>(solid), eye);
}

// A closed solid that lets no light through is met from outside alone, unless the eye is within: a ray that
// starts on what lies inside it would have had to get there first.
void Planner::within()
{
    plan_.enteredOnly.assign(scene_.objects.size(), false);
    const bool still = scene_.animated.empty();
    const bool wanted = scene_.plan.within != PlanChoices::Within::always &&
                        scene_.plan.force != PlanChoices::Force::all && still;
    std::size_t solids = 0;
    std::size_t entered = 0;
    for (std::size_t id = 0; id < scene_.objects.size(); ++id) {
        const auto& object = scene_.objects[id];
        if (!isSolid(object.primitive))
            continue;
        ++solids;
        const bool clear = scene_.materials[object.material].transmit > 0.0;
        plan_.enteredOnly[id] = wanted && !clear && isOutside(object.primitive, scene_.camera.eye);
        entered += plan_.enteredOnly[id] ? 1 : 0;
    }
    add("solids seen from within", entered < solids,
        !still ? "the scene is animated"
               : fmt::format("{} of {} solids are clear or hold the eye", solids - entered, solids),
        solids == 0 ? "no solids" : "all are opaque, and the eye is outside", {});
}

} // namespace dioptre
