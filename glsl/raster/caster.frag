// Of a shadow map: how far the light gets.

#include "raster/shadow_view.glsl"
#include "raster/uniforms.glsl"
#include "raster/shadow_map.glsl"

in vec4 v_place;

out float o_depth;

void main()
{
    ShadowView view = u_shadow_views[u_shadow_view];
    o_depth = lightDepth(view, v_place.xyz / v_place.w - view.eye.xyz);
}
