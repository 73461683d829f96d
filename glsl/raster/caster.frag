// Of a shadow map: how far the light gets.

#include "raster/shadow_view.glsl"
#include "raster/uniforms.glsl"
#include "raster/nearness.glsl"
#include "raster/shadow_map.glsl"

in vec4 v_place;

out float o_depth;

void main()
{
    ShadowView view = u_shadow_views[u_shadow_view];
    o_depth = lightDepth(view, v_place.xyz / v_place.w - view.eye.xyz);
    // The larger the nearer, whatever the distance; parallel rays come from both sides of the view's eye.
    float along = o_depth * view.forward.w;
    gl_FragDepth = view.eye.w > 0.5 ? nearness(view.forward.w, v_place.w) : 0.5 - 0.5 * along / (1.0 + abs(along));
}
