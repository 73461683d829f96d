#include "raster/shadow_views.h"

#include "raster/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dioptre
{
namespace
{

using packed::vec4;

// A spot whose cone is wider looks all around: its single map would be stretched at the edges.
constexpr double widestCone_rad = std::numbers::pi / 3.0;

struct Axes {
    glm::dvec3 right, up, forward;
};

Axes axesAlong(const glm::dvec3& forward)
{
    const glm::dvec3 reference =
        std::abs(forward.y) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, reference));
    return {right, glm::cross(right, forward), forward};
}

// Objects that a map must hold: a plane has no end, and its patch is far larger than what stands on it.
std::vector<const PackedObject*> heldBy(const PackedScene& scene, const std::vector<bool>& casts)
{
    std::vector<const PackedObject*> held;
    for (std::size_t id = 0; id < scene.objects.size(); ++id)
        if (casts[id] && scene.objects[id].kind != packed::KIND_PLANE)
            held.push_back(&scene.objects[id]);
    return held;
}

Extent extentOfAll(const std::vector<const PackedObject*>& objects, const glm::dvec3& direction)
{
    if (objects.empty())
        return {-1.0, 1.0};
    Extent all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const auto* object : objects) {
        const Extent one = extentAlong(*object, direction);
        all = {std::min(all.low, one.low), std::max(all.high, one.high)};
    }
    return all;
}

// Along parallel rays: as much as stands in the light's way. What is beside the map is lit.
packed::ShadowView parallelView(const packed::Light& light, const std::vector<const PackedObject*>& held)
{
    const Axes axes = axesAlong(glm::dvec3(light.direction));
    packed::ShadowView view{};
    glm::dvec3 middle(0.0);
    const auto half = [&](const glm::dvec3& axis) {
        const Extent extent = extentOfAll(held, axis);
        middle += 0.5 * (extent.low + extent.high) * axis;
        // Some more, so that no object ends on the map's edge.
        return std::max(0.51 * (extent.high - extent.low), std::numeric_limits<float>::min() * 1e6);
    };
    view.right = vec4(axes.right / half(axes.right), 0.0);
    view.up = vec4(axes.up / half(axes.up), 0.0);
    view.forward = vec4(axes.forward, 0.0);
    view.forward.w = 1.0 / half(axes.forward);
    view.eye = vec4(middle, 0.0);
    return view;
}

packed::ShadowView perspectiveView(const packed::Light& light, const Axes& axes, double tangent,
                                   double nearest)
{
    packed::ShadowView view{};
    view.eye = vec4(glm::dvec3(light.position), 1.0);
    view.right = vec4(axes.right / tangent, 0.0);
    view.up = vec4(axes.up / tangent, 0.0);
    view.forward = vec4(axes.forward, nearest);
    return view;
}

// No more than the least distance ahead of what is seen: half of that to the nearest object, as the corner of
// a face of the cube lies 1.73 times as far as its middle.
double nearestOf(const glm::dvec3& eye, const std::vector<const PackedObject*>& held)
{
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 1.0;
    for (const auto* object : held) {
        double outside = 0.0; // of a box about the object
        double reach = 0.0;
        for (const glm::dvec3& axis :
             {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)}) {
            const Extent extent = extentAlong(*object, axis);
            const double at = glm::dot(eye, axis);
            outside = std::max({outside, extent.low - at, at - extent.high});
            reach = std::max({reach, at - extent.low, extent.high - at});
        }
        nearest = std::min(nearest, outside);
        farthest = object == held.front() ? reach : std::max(farthest, reach);
    }
    return std::max(0.5 * std::min(nearest, farthest), 1e-5 * farthest); // a light may touch an object
}

double coneOf(const packed::Light& light)
{
    return 2.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(light.direction.w)));
}

void addAllAround(ShadowViews& all, const packed::Light& light, double nearest)
{
    for (int face = 0; face < 6; ++face) {
        glm::dvec3 forward(0.0);
        forward[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
        all.views.push_back(perspectiveView(light, axesAlong(forward), 1.0, nearest));
    }
}

} // namespace

ShadowViews shadowViews(const PackedScene& scene, const std::vector<bool>& casts)
{
    ShadowViews all;
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
        const auto& light = scene.lights[static_cast<std::size_t>(i)];
        std::vector<bool> casting = casts;
        if (i >= scene.firstGlow)
            casting[static_cast<std::size_t>(light.diffuse.w)] = false;
        const auto held = heldBy(scene, casting);
        const int first = static_cast<int>(all.views.size());
        const bool spot = i >= scene.firstSpot && i < scene.firstGlow;
        if (i < scene.firstPoint)
            all.views.push_back(parallelView(light, held));
        else if (spot && coneOf(light) <= widestCone_rad)
            all.views.push_back(perspectiveView(light, axesAlong(glm::dvec3(light.direction)),
                                                std::tan(coneOf(light)) * 1.01,
                                                nearestOf(glm::dvec3(light.position), held)));
        else
            addAllAround(all, light, nearestOf(glm::dvec3(light.position), held));
        all.lights.push_back({first, static_cast<int>(all.views.size()) - first});
    }
    return all;
}

} // namespace dioptre
