#include "raster/raster_scene.h"

#include "raster/extent.h"
#include "raster/raster_plan.h"
#include "render/kernel_choice.h"
#include "render/pack.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// What the planner must know: one form, geometry in a table that vertices can ask, nothing that rays need.
Scene asTable(Scene scene)
{
    Trace trace;
    trace.cutOff = scene.trace.cutOff;
    trace.form = SceneForm::loop;
    trace.lightType = scene.trace.lightType;
    scene.trace = trace;
    scene.plan = {};
    scene.plan.values = PlanChoices::Values::uniforms;
    scene.plan.lookup = PlanChoices::Lookup::table;
    scene.plan.kernels = PlanChoices::Kernels::plain;
    scene.plan.tiles = PlanChoices::Tiles::off;
    for (auto& typical : scene.typical)
        typical = asTable(std::move(typical));
    return scene;
}

// The least distance ahead of the eye at which a pixel can show anything: that of the nearest surface, seen
// at the picture's corner; where the eye touches a surface, a small share of what it looks across.
double nearOf(const Scene& scene, const PackedScene& packed, const ViewSettings& view)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& object : scene.objects)
        nearest = std::min(nearest, distanceTo(object.primitive, scene.camera.eye));
    const double up = glm::length(glm::dvec3(packed.camera.up));
    const double right = up * view.width / view.height;
    const double corner = std::sqrt(1.0 + up * up + right * right);
    return std::isfinite(nearest)
               ? std::max(0.5 * nearest / corner, 1e-12 * glm::length(scene.camera.target - scene.camera.eye))
               : 1.0;
}

void setPatches(RasterScene& raster)
{
    auto& scene = raster.prepared.scene;
    for (std::size_t id = 0; id < scene.objects.size(); ++id)
        if (const auto* plane = std::get_if<Plane>(&scene.objects[id].primitive))
            raster.prepared.packed.objects[id].shape.anchor.w =
                hasEndlessPlanes(raster.method)
                    ? 1.0
                    : 0.5 * plane->rasterExtent_m.value_or(usualPatch_m(typicalOf(scene), *plane));
}

// What hangs on the scene's numbers.
void derive(RasterScene& raster, const ViewSettings& view)
{
    const Scene& scene = raster.prepared.scene;
    setPatches(raster);
    const auto& inside = scene.camera.inside;
    raster.eyeAbsorption = inside ? scene.materials[*inside].absorption : glm::dvec3(0.0);
    raster.near_m = nearOf(scene, raster.prepared.packed, view);
    raster.casts.clear();
    for (const auto& object : scene.objects)
        raster.casts.push_back(scene.materials[object.material].shadow == ShadowKind::opaque);
    raster.shadows = {};
    if (castsShadows(raster.prepared.plan))
        raster.shadows = shadowViews(raster.prepared.packed, raster.casts, raster.allAround);
}

} // namespace

double usualPatch_m(const Scene& scene, const Plane& plane)
{
    double farthest = glm::length(scene.camera.eye - plane.point);
    for (const auto& object : scene.objects) {
        if (std::holds_alternative<Plane>(object.primitive))
            continue;
        const PackedObject packed = packShape(object, plane.point);
        glm::dvec3 reach(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 direction(0.0);
            direction[axis] = 1.0;
            const Extent extent = extentAlong(packed, direction);
            reach[axis] = std::max(std::abs(extent.low), std::abs(extent.high));
        }
        farthest = std::max(farthest, glm::length(reach));
    }
    return farthest > 0.0 ? 8.0 * farthest : 8.0;
}

RasterScene prepareRaster(const Scene& scene, const ViewSettings& view, const Method& method,
                          const PictureSource& pictures)
{
    RasterScene raster;
    raster.method = method;
    ViewSettings light = view;
    light.view = DataView::none;
    raster.prepared = prepare(asTable(scene), light, pictures);
    raster.prepared.plan = rasterPlan(raster.prepared, method);
    raster.allAround = shineAllAround(raster.prepared.packed, raster.prepared.scene.animated);
    derive(raster, view);
    return raster;
}

void moveTo(RasterScene& raster, const Scene& scene, const ViewSettings& view)
{
    moveTo(raster.prepared, asTable(scene), view);
    derive(raster, view);
}

} // namespace dioptre
