// Where no object covers a pixel: the sky.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/lat_long.glsl"
#include "trace/uniforms.glsl"
#include "raster/uniforms.glsl"
#include "trace/path.glsl"
#include "trace/camera.glsl"
#include "trace/sky.glsl"

out vec4 o_sample;

void main()
{
    Path eye = eyePath(gl_FragCoord.xy + u_tile_origin_px + sampleOffset(u_sample_first));
    vec3 radiance = skyRadiance(eye.ray.direction);
#ifdef HAS_EYE_MEDIUM
    radiance *= exp(-u_eye_absorption * FAR_AWAY);
#endif
    o_sample = vec4(radiance, 0.0);
}
