// dioptre's ray tracer, in the order that light travels back: from the eye through a pixel, to the nearest object, to what
// its surface is and how it is lit, and on along mirrored and refracted rays until they no longer matter.

#ifdef HAS_PRECISE
#extension GL_ARB_gpu_shader5 : require
#endif

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/sphere.glsl"
#include "kernel/cylinder.glsl"
#include "kernel/flat.glsl"
#ifdef HAS_CHOSEN_KERNELS
#include "kernel/exact.glsl"
#include "kernel/fine.glsl"
#include "kernel/fine_round.glsl"
#include "kernel/fine_flat.glsl"
#include "kernel/fine_crossing.glsl"
#include "kernel/curved.glsl"
#include "kernel/curved_crossing.glsl"
#endif
#include "kernel/dielectric.glsl"
#include "kernel/lobe.glsl"
#include "kernel/microfacet.glsl"
#include "kernel/lat_long.glsl"
#include "kernel/footprint.glsl"
#include "trace/uniforms.glsl"
#include "generated/receive.glsl"
#ifdef HAS_TRUST
#include "kernel/blur.glsl"
#endif
#include "trace/path.glsl"
#include "trace/camera.glsl"
#include "trace/nearest.glsl"
#include "generated/scene.glsl"
#include "trace/surface.glsl"
#include "trace/light.glsl"
#include "generated/lights.glsl"
#include "trace/sky.glsl"
#include "trace/lost_weight.glsl"
#ifdef HAS_TRUST
#include "trace/trust.glsl"
#endif
#include "trace/scatter.glsl"
#include "generated/tree.glsl"

out vec4 o_sum; // rgb: radiance, a: rays traced; both summed over this draw's samples

void main()
{
#ifdef HAS_SHARED_VALUES
    receiveShared();
#endif
    vec2 centre_px = gl_FragCoord.xy + u_tile_origin_px;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < u_sample_count; ++i)
        sum += traceTree(eyePath(centre_px + sampleOffset(u_sample_first + i)));
    o_sum = sum;
}
