// Of the rasterised methods: the radiance of a pixel that a facet covers, by the tracer's light and reflectance.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/flat.glsl"
#include "kernel/dielectric.glsl"
#include "kernel/lobe.glsl"
#include "kernel/microfacet.glsl"
#include "kernel/lat_long.glsl"
#include "kernel/footprint.glsl"
#include "trace/uniforms.glsl"
#include "raster/shadow_view.glsl"
#include "raster/uniforms.glsl"
#include "trace/path.glsl"
#include "trace/nearest.glsl"
#include "generated/scene.glsl"
#include "trace/surface.glsl"
#include "trace/light.glsl"
#include "trace/sky.glsl"
#include "raster/nearness.glsl"
#include "raster/surroundings.glsl"
#ifdef HAS_SHADOW_MAPS
#include "raster/shadow_map.glsl"
#endif

in vec4 v_place;
in vec3 v_outward;
#ifdef HAS_FACETS
flat in vec3 v_facet_normal;
#endif
#ifdef HAS_LIT_FACETS
flat in vec3 v_matt[LIT_COUNT];
#endif
#ifdef HAS_LIT_VERTICES
in vec3 v_matt[LIT_COUNT];
#endif
#ifdef HAS_SHINY_FACETS
flat in vec3 v_shine[LIT_COUNT];
#endif
#ifdef HAS_SHINY_VERTICES
in vec3 v_shine[LIT_COUNT];
#endif
#ifdef HAS_AMBIENT_FACETS
flat in vec3 v_ambient;
#endif
#ifdef HAS_AMBIENT_VERTICES
in vec3 v_ambient;
#endif

#include "generated/lights.glsl"

out vec4 o_sample;

void main()
{
    int kind = drawnKind();
    Shape shape = drawnShape();
    Material material = drawnMaterial();
    vec3 position = v_place.xyz / v_place.w;
    vec3 fromEye = position - u_camera.eye.xyz;
    float away_m = length(fromEye);
    Ray ray;
    ray.origin = u_camera.eye.xyz;
    ray.direction = fromEye / away_m;
    ray.from = -1;
    vec3 outward = normalize(v_outward);
    Surface surface;
    surface.position = position;
    surface.normal = u_side * outward;
#ifdef HAS_FACETS
    surface.normal = u_side * v_facet_normal;
#endif
    surface.colour = material.colour.xyz;
#ifdef HAS_COORDINATES
    surface.colour *= worn(position, outward, kind, shape, material, away_m, dot(ray.direction, surface.normal));
#endif
    vec3 radiance = vec3(0.0);
#ifdef HAS_AMBIENT
    radiance += u_ambient * ambientColour(surface, material);
#endif
#ifdef HAS_LIGHTS
#ifdef HAS_SHADOW_MAPS
    // The facet's own normal: that of the shape as it is meant leans otherwise.
    vec3 facing = normalize(cross(normalize(dFdx(position)), normalize(dFdy(position))));
    radiance += lightsReflected(surface, material, ray, facing);
#else
    radiance += lightsReflected(surface, material, ray);
#endif
#endif
#ifdef HAS_MIRROR_RAY
    radiance *= (1.0 - material.mirror.w) * (1.0 - transmitOf(material));
    radiance += surroundings(ray.direction, surface.normal, kind, shape, material);
#endif
#ifdef HAS_EMISSION
    radiance += material.emission.xyz;
#endif
#ifdef HAS_EYE_MEDIUM
    radiance *= exp(-u_eye_absorption * away_m);
#endif
    gl_FragDepth = nearness(u_near_m, v_place.w);
    o_sample = vec4(radiance, 0.0);
}
