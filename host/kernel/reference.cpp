#include "kernel/reference.h"

#include "base/interruption.h"
#include "base/parallel.h"
#include "kernel/sampler.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace reference
{

// Of what the plan defines for the device, what light needs: every feature is in, and the scene's data
// decide.
#define HAS_COORDINATES
#define HAS_PLANE_COORDINATES
#define HAS_SPHERE_COORDINATES
#define HAS_CYLINDER_COORDINATES
#define HAS_DISK_COORDINATES
#define HAS_RECTANGLE_COORDINATES
#define HAS_TRIANGLE_COORDINATES
#define HAS_CHECKER
#define HAS_PICTURES
#define HAS_EMISSION
#define HAS_ANY_AMBIENT
#define HAS_AMBIENT
#define HAS_LOCAL
#define HAS_LIGHTS
#define HAS_LIGHT_LOOPS
#define HAS_DIRECTIONAL_LIGHT
#define HAS_POINT_LIGHT
#define HAS_GLOW
#define HAS_PLACED_LIGHT
#define HAS_SPOT_LIGHT
#define HAS_LIGHT_AMBIENT
#define HAS_HIGHLIGHT
#define HAS_PHONG
#define HAS_BLINN
#define HAS_MICROFACET
#define HAS_SHADOWS
#define HAS_TINTED_SHADOWS
#define HAS_SHADOW_ABSORPTION
#define HAS_SKY_GRADIENT
#define HAS_SKY_PICTURE

#include "kernel/glsl_as_cpp.h"

static const std::vector<std::vector<Picture>>* u_pictures;
static const Picture* u_sky_picture;

static vec4 textureLod(const Picture* picture, vec2 uv, double)
{
    return picture != nullptr ? sampleBilinear(*picture, uv, Wrap::uOnly) : vec4(1.0);
}

#define float double
#include "kernel/footprint.glsl"
#undef float

static vec3 pictureColour(int picture, vec2 uv, vec2 wraps, vec2 footprint)
{
    if (picture < 0)
        return vec3(1.0);
    const auto& levels = (*u_pictures)[static_cast<std::size_t>(picture)];
    const vec2 size(levels.front().width, levels.front().height);
    const double level = pictureLevel(footprint, size);
    return vec3(sampleTrilinear(levels, withinPicture(uv, wraps, level, size), level));
}

#include "kernel/tracer_as_cpp.h"

// Points the uniforms at the scene; `table` must outlive the rendering.
static void setUniforms(const PackedScene& scene, const ShapeTable& table, int width, int height)
{
    setTracer(scene, table, width, height);
    u_pictures = &scene.pictures;
    u_sky_picture = scene.sky_picture.empty() ? nullptr : &scene.sky_picture.front();
}

} // namespace reference

Picture renderReference(const PackedScene& scene, int width, int height, int samples,
                        const PixelRectangle& region)
{
    const ShapeTable table = plainShapeTable(scene);
    reference::setUniforms(scene, table, width, height);
    return reference::traceRegion(scene, samples, region);
}

} // namespace dioptre
