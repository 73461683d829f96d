#include "render/kernel_choice.h"
#include "render/pack.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

double largest(const glm::dvec3& colour)
{
    return std::max({colour.x, colour.y, colour.z});
}

// A sphere around a shape; planes have none.
struct Bound {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

std::optional<Bound> boundOf(const Primitive& primitive)
{
    if (const auto* sphere = std::get_if<Sphere>(&primitive))
        return Bound{sphere->centre, sphere->radius};
    if (const auto* cylinder = std::get_if<Cylinder>(&primitive))
        return Bound{cylinder->base + 0.5 * cylinder->axis,
                     std::hypot(cylinder->radius, 0.5 * glm::length(cylinder->axis))};
    if (const auto* disk = std::get_if<Disk>(&primitive))
        return Bound{disk->centre, disk->radius};
    if (const auto* rectangle = std::get_if<Rectangle>(&primitive)) {
        const auto& u = rectangle->edgeU;
        const auto& v = rectangle->edgeV;
        return Bound{rectangle->corner + 0.5 * (u + v),
                     0.5 * std::max(glm::length(u + v), glm::length(u - v))};
    }
    if (const auto* triangle = std::get_if<Triangle>(&primitive)) {
        const glm::dvec3 middle = (triangle->a + triangle->b + triangle->c) / 3.0;
        return Bound{middle, std::max({glm::distance(middle, triangle->a), glm::distance(middle, triangle->b),
                                       glm::distance(middle, triangle->c)})};
    }
    return std::nullopt;
}

// The diagonal of the box around the eye and everything bounded; metres.
double sceneSize(const Scene& scene)
{
    glm::dvec3 low = scene.camera.eye;
    glm::dvec3 high = scene.camera.eye;
    for (const auto& object : scene.objects) {
        if (const auto bound = boundOf(object.primitive)) {
            low = glm::min(low, bound->centre - bound->radius);
            high = glm::max(high, bound->centre + bound->radius);
        }
    }
    return glm::distance(low, high);
}

// The nearest that a light stands to any surface but the one that glows, never below 1 % of the scene's size.
double nearestSurface(const Scene& scene, const glm::dvec3& position, std::optional<std::size_t> glowing)
{
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (i != glowing)
            nearest = std::min(nearest, distanceTo(scene.objects[i].primitive, position));
    return std::max({nearest, 0.01 * sceneSize(scene), packed::NEAREST_LIGHT});
}

// What a highlight may be of light of 1: lobes never exceed it, a rough mirror's peak is 1 / (4 alpha^2)
// head-on.
double mostShine(const Scene& scene, const Plan& plan)
{
    double most = 1.0;
    for (const auto i : plan.materials) {
        const Material& material = scene.materials[i];
        if (material.model != ReflectanceModel::microfacet)
            continue;
        const double headOn =
            std::lerp(largest(material.specular), largest(material.colour), material.metalness);
        most = std::max(most, headOn / (4.0 * std::pow(material.roughness, 4.0)));
    }
    return most;
}

double attenuated(const glm::dvec3& attenuation, double distance)
{
    return 1.0 / (attenuation.x + distance * (attenuation.y + distance * attenuation.z));
}

} // namespace

double brightestRadiance(const Scene& scene, const Plan& plan, double sky)
{
    double brightest = std::max(1.0, sky);
    for (const auto i : plan.materials)
        brightest = std::max(brightest, largest(scene.materials[i].emission));
    glm::dvec3 everywhere(0.0);
    for (const auto& light : scene.lights)
        everywhere += light.ambient;
    brightest = std::max(brightest, largest(everywhere));
    const double shine = mostShine(scene, plan);
    for (const auto i : plan.placedLights) {
        const auto& light = scene.lights[i];
        const double colour = std::max(largest(light.diffuse), shine * largest(light.specular));
        const bool far = light.kind == Light::Kind::directional;
        const double distance = far ? 0.0 : nearestSurface(scene, light.position, std::nullopt);
        brightest = std::max(brightest, far ? colour : colour * attenuated(light.attenuation, distance));
    }
    for (const auto i : plan.glowing) {
        const auto& sphere = std::get<Sphere>(scene.objects[i].primitive);
        const double distance = std::max(nearestSurface(scene, sphere.centre, i), sphere.radius);
        const double share = sphere.radius / distance;
        brightest = std::max(brightest, shine * largest(scene.materials[scene.objects[i].material].emission) *
                                            share * share);
    }
    return brightest;
}

} // namespace dioptre
