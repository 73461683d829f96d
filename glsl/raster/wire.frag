// Of the facets' edges: one bright colour, that no exposure makes white.

#include "raster/uniforms.glsl"
#include "raster/nearness.glsl"

in vec4 v_place;

out vec4 o_sample;

void main()
{
    gl_FragDepth = 1.001 * nearness(u_near_m, v_place.w); // over the facets themselves
    o_sample = vec4(1.0, 0.6, 0.0, 0.0);
}
