// arctangent() and the driver's own of whole numbers about the middle of 257x257 pixels, and where latLong() puts a pole.

#include "shared/constants.glsl"
#include "kernel/lat_long.glsl"

uniform float u_unit; // 1, or -1: zeros become negative ones

out vec4 o_angles;

void main()
{
    vec2 point = u_unit * (floor(gl_FragCoord.xy) - 128.0);
    o_angles = vec4(arctangent(point.y, point.x), atan(point.y, point.x), latLong(vec3(0.0, point.y, 0.0)));
}
