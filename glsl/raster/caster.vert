// Of a shadow map: what a light looks at.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "trace/uniforms.glsl"
#include "raster/shadow_view.glsl"
#include "raster/uniforms.glsl"
#include "raster/object.glsl"
#include "raster/unit_shape.glsl"

layout(location = 0) in vec4 a_place; // on the unit shape

out vec4 v_place; // scene frame, homogeneous

void main()
{
    v_place = placeInScene(a_place, drawnKind(), drawnShape());
    ShadowView view = u_shadow_views[u_shadow_view];
    vec3 offset = v_place.xyz - v_place.w * view.eye.xyz;
    float ahead = dot(offset, view.forward.xyz);
    bool perspective = view.eye.w > 0.5;
    vec2 clip = vec2(dot(offset, view.right.xyz), dot(offset, view.up.xyz));
    gl_Position = vec4(clip, 0.0, perspective ? ahead : v_place.w);
}
