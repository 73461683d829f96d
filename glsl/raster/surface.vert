// Of the rasterised methods: places a vertex, and lights it where facets or vertices are lit.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/lobe.glsl"
#include "kernel/microfacet.glsl"
#include "kernel/lat_long.glsl"
#include "kernel/footprint.glsl"
#include "trace/uniforms.glsl"
#include "raster/shadow_view.glsl"
#include "raster/uniforms.glsl"
#include "trace/path.glsl"
#include "trace/camera.glsl"
#include "trace/nearest.glsl"
#include "generated/scene.glsl"
#include "trace/surface.glsl"
#include "trace/light.glsl"
#include "raster/lit_vertex.glsl"
#include "raster/unit_shape.glsl"
#include "raster/cell.glsl"
#include "raster/project.glsl"

layout(location = 0) in vec4 a_place;  // on the unit shape
layout(location = 1) in vec3 a_normal; // there
#ifdef HAS_FACETS
layout(location = 2) in vec3 a_facet_place; // the middle of the facet
layout(location = 3) in vec3 a_facet_normal;
#endif

out vec4 v_place;   // scene frame, homogeneous
out vec3 v_outward; // normal of the shape as it is meant
#ifdef HAS_FACETS
flat out vec3 v_facet_normal;
#endif
#ifdef HAS_LIT_FACETS
flat out vec3 v_matt[LIT_COUNT]; // light that the surface's colour multiplies
#endif
#ifdef HAS_LIT_VERTICES
out vec3 v_matt[LIT_COUNT];
#endif
#ifdef HAS_SHINY_FACETS
flat out vec3 v_shine[LIT_COUNT];
#endif
#ifdef HAS_SHINY_VERTICES
out vec3 v_shine[LIT_COUNT];
#endif
#ifdef HAS_AMBIENT_FACETS
flat out vec3 v_ambient;
#endif
#ifdef HAS_AMBIENT_VERTICES
out vec3 v_ambient;
#endif

#include "generated/lights.glsl"

void main()
{
    int kind = drawnKind();
    Shape shape = drawnShape();
    v_place = placeInScene(a_place, kind, shape);
    v_outward = normalInScene(a_normal, kind, shape);
#ifdef HAS_FACETS
    v_facet_normal = normalize(normalInScene(a_facet_normal, kind, shape));
#endif
#ifdef HAS_LIT_FACETS
    lightVertex(placeInScene(vec4(a_facet_place, 1.0), kind, shape).xyz, u_side * v_facet_normal);
#endif
#ifdef HAS_LIT_VERTICES
    lightVertex(v_place.xyz, u_side * normalize(v_outward));
#endif
    gl_Position = clipFromScene(v_place);
}
