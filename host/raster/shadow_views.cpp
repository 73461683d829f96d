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

// A spot whose cone is wider looks all around: its single map would be stretched at the edges. One whose cone
// grows while its maps stay is cut at the second angle.
constexpr double widestCone_rad = std::numbers::pi / 3.0;
constexpr double widestMap_rad = 0.47 * std::numbers::pi;

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

std::vector<const PackedObject*> chosen(const PackedScene& scene, const std::vector<bool>& casts)
{
    std::vector<const PackedObject*> objects;
    for (std::size_t id = 0; id < scene.objects.size(); ++id)
        if (casts[id])
            objects.push_back(&scene.objects[id]);
    return objects;
}

// Whether a flat shape shades nothing, as all else lies between its plane and the light: a ground, a wall.
// `light`: its place, or of w = 0 the direction to it.
bool isBehindAll(const PackedScene& scene, std::size_t id, const vec4& light)
{
    const auto& shape = scene.objects[id].shape;
    const glm::dvec3 normal(shape.axis);
    const double height = glm::dot(normal, glm::dvec3(shape.anchor));
    const double side = glm::dot(normal, glm::dvec3(light)) - light.w * height;
    for (std::size_t other = 0; other < scene.objects.size(); ++other) {
        if (other == id)
            continue;
        if (scene.objects[other].kind == packed::KIND_PLANE)
            return false;
        const Extent extent = extentAlong(scene.objects[other], normal);
        // What stands on it may be under it by rounding.
        const double rounding = 1e-6 * (extent.high - extent.low);
        if (side > 0.0 ? extent.low < height - rounding : extent.high > height + rounding)
            return false;
    }
    return true;
}

// Those that a light's maps hold: no plane, which has no end, no lamp in its own, and nothing that shades
// nothing.
std::vector<bool> castingOn(const PackedScene& scene, const std::vector<bool>& casts, const vec4& light,
                            int glowing)
{
    std::vector<bool> casting = casts;
    for (std::size_t id = 0; id < casting.size(); ++id) {
        const int kind = scene.objects[id].kind;
        if (kind == packed::KIND_PLANE || static_cast<int>(id) == glowing ||
            (casting[id] && kind > packed::KIND_PLANE && isBehindAll(scene, id, light)))
            casting[id] = false;
    }
    return casting;
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
        // Some more, so that no object ends on the map's edge; not 0 where all lies in a plane along the
        // light.
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
    if (held.empty())
        return 1.0;
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
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
        farthest = std::max(farthest, reach);
    }
    return std::max(0.5 * nearest, 1e-5 * farthest); // a light may touch an object
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

std::vector<bool> shineAllAround(const PackedScene& scene, const std::vector<std::string>& animated)
{
    const bool conesMove = std::ranges::any_of(
        animated, [](const std::string& path) { return path.find("cutoff_deg") != std::string::npos; });
    std::vector<bool> around;
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
        const bool spot = i >= scene.firstSpot && i < scene.firstGlow;
        const auto& light = scene.lights[static_cast<std::size_t>(i)];
        around.push_back(i >= scene.firstPoint && (!spot || conesMove || coneOf(light) > widestCone_rad));
    }
    return around;
}

ShadowViews shadowViews(const PackedScene& scene, const std::vector<bool>& casts,
                        const std::vector<bool>& allAround)
{
    ShadowViews all;
    for (std::size_t id = 0; id < scene.objects.size(); ++id) {
        const auto& shape = scene.objects[id].shape;
        const bool shades = casts[id] && scene.objects[id].kind == packed::KIND_PLANE;
        all.planeOf.push_back(shades ? static_cast<int>(all.planes.size()) : -1);
        if (shades)
            all.planes.emplace_back(glm::dvec3(shape.axis),
                                    glm::dot(glm::dvec3(shape.axis), glm::dvec3(shape.anchor)));
    }
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
        const auto& light = scene.lights[static_cast<std::size_t>(i)];
        const bool parallel = i < scene.firstPoint;
        const vec4 place =
            parallel ? vec4(-glm::dvec3(light.direction), 0.0) : vec4(glm::dvec3(light.position), 1.0);
        const auto casting = castingOn(scene, casts, place, static_cast<int>(light.diffuse.w));
        const auto held = chosen(scene, casting);
        const int first = static_cast<int>(all.views.size());
        if (parallel)
            all.views.push_back(parallelView(light, held));
        else if (allAround[static_cast<std::size_t>(i)])
            addAllAround(all, light, nearestOf(glm::dvec3(light.position), held));
        else
            all.views.push_back(perspectiveView(light, axesAlong(glm::dvec3(light.direction)),
                                                std::tan(std::min(coneOf(light), widestMap_rad)) * 1.01,
                                                nearestOf(glm::dvec3(light.position), held)));
        all.lights.push_back({first, static_cast<int>(all.views.size()) - first, casting});
    }
    return all;
}

} // namespace dioptre
