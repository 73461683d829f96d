#include "render/plan.h"

namespace dioptre
{
namespace
{

void showUnlit(Scene& scene)
{
    Light everywhere;
    everywhere.kind = Light::Kind::ambient;
    everywhere.ambient = glm::dvec3(1.0);
    scene.lights = {everywhere};
    for (auto& material : scene.materials) {
        material.ambient.reset();
        material.light = false;
    }
}

void showLightsAlone(Scene& scene)
{
    std::erase_if(scene.lights, [](const Light& light) { return light.kind == Light::Kind::ambient; });
    for (auto& light : scene.lights)
        light.ambient = glm::dvec3(0.0);
    scene.sky = Sky{};
}

} // namespace

Scene underLightType(Scene scene)
{
    if (scene.trace.lightType == LightType::unlit)
        showUnlit(scene);
    if (scene.trace.lightType == LightType::lightsOnly)
        showLightsAlone(scene);
    for (auto& typical : scene.typical)
        typical = underLightType(std::move(typical));
    return scene;
}

} // namespace dioptre
