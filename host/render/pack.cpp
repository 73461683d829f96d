#include "render/pack.h"

#include "render/pack_fine.h"
#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dioptre
{
namespace
{

using packed::vec4;

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

// Index of `value` in the plan's list; -1 where it is not there.
template <typename Value>
int indexIn(const std::vector<Value>& list, const Value& value)
{
    const auto found = std::find(list.begin(), list.end(), value);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

// Metres between the points that may become the origin: 11 to 23 times what the eye looks across.
double originGrid(const Camera& camera)
{
    return std::exp2(std::round(std::log2(glm::distance(camera.eye, camera.target))) + 4.0);
}

// The scene's own, though earlier edits may have widened the plan; never more than queues and stacks have
// room for.
int budgetOf(const Scene& scene, const Plan& plan)
{
    if (plan.tree == RayTree::single)
        return 1;
    const Scene& own = ownTypicalOf(scene);
    const int budget = own.trace.budget.value_or(defaultBudget(own, plan.materials));
    const bool waits = plan.tree == RayTree::breadthFirst || plan.tree == RayTree::depthFirst;
    return waits ? std::min(plan.budget, budget) : budget;
}

packed::Camera packCamera(const Scene& scene, const Plan& plan, const View& view, const glm::dvec3& origin)
{
    const auto& camera = scene.camera;
    const glm::dmat3 frame = worldFromCamera(camera);
    const double half = std::tan(0.5 * radians(camera.fovY_deg));
    const int medium = camera.inside ? indexIn(plan.materials, *camera.inside) : -1;
    packed::Camera result;
    result.eye = vec4(camera.eye - origin, medium);
    result.right = vec4(half * frame[0], 0.0);
    result.up = vec4(half * frame[1], 0.0);
    result.forward = vec4(-frame[2], 2.0 * half / view.height / std::sqrt(view.samples));
    return result;
}

packed::Sky packSky(const Sky& sky)
{
    packed::Sky result{};
    const double factor = std::exp2(sky.exposure);
    glm::dvec3 colours[3] = {sky.colour, sky.colour, sky.colour};
    if (sky.kind == Sky::Kind::gradient)
        std::copy(sky.gradient.begin(), sky.gradient.end(), colours);
    if (sky.kind == Sky::Kind::image)
        std::fill(colours, colours + 3, glm::dvec3(1.0));
    result.colour = vec4(factor * colours[0], 0.0);
    result.horizon = vec4(factor * colours[1], 0.0);
    result.zenith = vec4(factor * colours[2], 0.0);
    const double turn = radians(sky.rotation_deg);
    result.turn = vec4(std::cos(turn), std::sin(turn), sky.mirrorU ? -1.0 : 1.0, 0.0);
    return result;
}

// The interface's numbers for both ways through it, in double: the device never divides indices.
vec4 bendingOf(double inside, double outside)
{
    const double entering = inside / outside;
    const double leaving = outside / inside;
    return vec4(leaving, entering, (entering - 1.0) * (entering + 1.0), (leaving - 1.0) * (leaving + 1.0));
}

// What a material does to shadows, the same at every time: the shader's text holds it. Glass that is clear at
// times alone tints throughout, black at the others.
int shadowOf(const Material& typical)
{
    const bool tints =
        typical.shadow == ShadowKind::tinted && typical.transmit * (1.0 - typical.mirror) > 0.0;
    return typical.shadow == ShadowKind::none ? packed::SHADOW_NONE
           : tints                            ? packed::SHADOW_TINTED
                                              : packed::SHADOW_OPAQUE;
}

packed::Material packMaterial(const Scene& scene, const Plan& plan, std::size_t index)
{
    const Material& material = scene.materials[index];
    const Material air;
    const Material& outside = material.outside ? scene.materials[*material.outside] : air;
    const auto shadow = shadowOf(typicalOf(scene).materials[index]);
    // What tinted before the latest edits alone is black, and no medium of shadow rays.
    const bool tints = shadowOf(ownTypicalOf(scene).materials[index]) == packed::SHADOW_TINTED;
    const double passing = tints ? material.transmit * (1.0 - material.mirror) : 0.0;
    const Checker checker = material.checker.value_or(Checker{{glm::dvec3(1.0), glm::dvec3(1.0)}, 0.0});
    const bool hasAmbient = material.ambient.has_value();
    packed::Material result;
    result.colour =
        vec4(material.colour, indexIn(plan.pictures, PictureUse{material.image, material.encoding}));
    result.ambient = vec4(material.ambient.value_or(material.colour), hasAmbient ? 0.0 : 1.0);
    result.specular = vec4(material.specular, material.shininess);
    result.emission = vec4(material.emission, modelOf(material.model));
    result.microfacet = vec4(material.roughness * material.roughness, material.metalness, 0.0, 0.0);
    result.mirror = vec4(material.mirror * material.mirrorColour, material.mirror);
    result.checker = vec4(checker.colours[1], checker.size);
    result.checker_first = vec4(checker.colours[0], material.size);
    result.bending = bendingOf(material.ior, outside.ior);
    result.absorption =
        vec4(material.absorption, material.outside ? indexIn(plan.materials, *material.outside) : -1);
    result.shadow_tint = vec4(material.colour * passing, shadow);
    // Where an object holds the medium around, its chord counts this one's too, and the difference is left. A
    // medium that no object bounds counts on no shadow ray.
    const bool bounded = material.outside && std::ranges::any_of(scene.objects, [&](const Object& object) {
                             return object.material == *material.outside;
                         });
    const glm::dvec3 relative = material.absorption - (bounded ? outside.absorption : glm::dvec3(0.0));
    result.shadow_absorption = vec4(tints ? relative : glm::dvec3(0.0), material.transmit);
    return result;
}

packed::Light packLight(const Light& light, const glm::dvec3& origin)
{
    // The squared chord of the cone's half-angle. Rounding may take one above 4: a spot without a cone asks
    // for more.
    const double half = std::sin(0.5 * radians(light.cutoff_deg));
    const double chordSquared = light.cutoff_deg >= 180.0 ? 5.0 : 4.0 * half * half;
    packed::Light result;
    result.position = vec4(light.position - origin, 0.0);
    result.direction = vec4(light.direction, chordSquared);
    // A directional light's ambient part comes from everywhere: pack() adds it to the scene's.
    const bool everywhere = light.kind == Light::Kind::directional;
    result.ambient = vec4(everywhere ? glm::dvec3(0.0) : light.ambient, light.exponent);
    result.diffuse = vec4(light.diffuse, -1.0);
    result.specular = vec4(light.specular, packed::NEAREST_LIGHT);
    result.attenuation = vec4(light.attenuation, 0.0);
    return result;
}

// A glowing sphere's light: E (r/d)^2 on a white surface that faces the centre, exact while the whole sphere
// is in view.
packed::Light packGlow(const Scene& scene, std::size_t object, const glm::dvec3& origin)
{
    const auto& sphere = std::get<Sphere>(scene.objects[object].primitive);
    const auto& emission = scene.materials[scene.objects[object].material].emission;
    packed::Light result{};
    result.position = vec4(sphere.centre - origin, 0.0);
    result.diffuse = vec4(emission, static_cast<double>(object));
    result.specular = vec4(emission, sphere.radius);
    result.attenuation = vec4(0.0, 0.0, 1.0 / (sphere.radius * sphere.radius), 0.0);
    return result;
}

// Doubles reach further than the device's floats: what would become 0 or infinite there is refused here.
void refuseBeyondFloat(const Object& object, const PackedObject& packedObject)
{
    const auto& shape = packedObject.shape;
    bool fits = packedObject.kind == packed::KIND_PLANE || packedObject.kind >= packed::KIND_RECTANGLE ||
                static_cast<float>(shape.anchor.w) > 0.0F;
    for (const auto& row : {shape.anchor, shape.axis, shape.along_u, shape.along_v})
        for (int i = 0; i < 4; ++i)
            fits = fits && std::isfinite(static_cast<float>(row[i]));
    if (!fits)
        fail(ExitCode::badInput, object.where, "this object is too small or too large for single precision",
             "scale the scene so that its lengths lie between 1e-30 and 1e30");
}

} // namespace

int modelOf(ReflectanceModel model)
{
    return model == ReflectanceModel::phong        ? packed::MODEL_PHONG
           : model == ReflectanceModel::blinn      ? packed::MODEL_BLINN
           : model == ReflectanceModel::microfacet ? packed::MODEL_MICROFACET
                                                   : packed::MODEL_LAMBERT;
}

glm::dvec3 sceneOrigin(const Scene& scene)
{
    const double grid = originGrid(scene.camera);
    return grid * glm::round(scene.camera.eye / grid);
}

bool originServes(const glm::dvec3& origin, const Camera& camera)
{
    const glm::dvec3 away = glm::abs(camera.eye - origin);
    return std::max({away.x, away.y, away.z}) <= 2.0 * originGrid(camera);
}

PackedScene pack(const Scene& scene, const Plan& plan, const View& view)
{
    // Constants in the shader's text are relative to it: it stays where it is while the camera moves.
    const glm::dvec3 origin = sceneOrigin(typicalOf(scene));
    PackedScene result;
    for (std::size_t id = 0; id < scene.objects.size(); ++id) {
        const auto& object = scene.objects[id];
        result.objects.push_back(packShape(object, origin));
        refuseBeyondFloat(object, result.objects.back());
        result.objects.back().apart = plan.kernels[id] != KernelForm::plain;
        result.objects.back().fine = packFine(result.objects.back());
        result.objects.back().material = indexIn(plan.materials, object.material);
    }
    for (std::size_t i = 0; i < scene.moving.size(); ++i)
        result.objects[scene.moving[i]].moving = static_cast<int>(i);
    for (const auto i : plan.materials)
        result.materials.push_back(packMaterial(scene, plan, i));
    for (const auto i : plan.placedLights) {
        result.lights.push_back(packLight(scene.lights[i], origin));
        result.firstPoint += scene.lights[i].kind < Light::Kind::point ? 1 : 0;
        result.firstSpot += scene.lights[i].kind < Light::Kind::spot ? 1 : 0;
    }
    result.firstGlow = static_cast<int>(result.lights.size());
    for (const auto i : plan.glowing)
        result.lights.push_back(packGlow(scene, i, origin));
    for (const auto& light : scene.lights)
        if (light.kind == Light::Kind::ambient || light.kind == Light::Kind::directional)
            result.ambient += light.ambient;
    result.camera = packCamera(scene, plan, view, origin);
    result.sky = packSky(scene.sky);
    result.tree = plan.tree;
    result.budget = budgetOf(scene, plan);
    result.depth = scene.trace.depth.value_or(result.depth);
    result.poolSlots = plan.poolSlots;
    return result;
}

} // namespace dioptre
