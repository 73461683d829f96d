// Error-free transformations of the pair of floats in this pixel: a sum and a product with what their rounding lost. A
// compiler that regroups or contracts them makes the errors wrong; the features choose what is to stop it.

#ifdef HAS_GPU_SHADER5
#extension GL_ARB_gpu_shader5 : require
#endif

uniform sampler2D u_pairs; // red and green: a and b
out vec4 o_exact;          // sum, its error, product, its error

#include "shared/constants.glsl"
#include "kernel/exact.glsl"

void main()
{
    vec2 pair = texelFetch(u_pairs, ivec2(gl_FragCoord.xy), 0).xy;
    o_exact = vec4(twoSum(pair.x, pair.y), twoProduct(pair.x, pair.y));
}
