// Error-free transformations of the pair of floats in this pixel: a sum and a product with what their rounding lost. A
// compiler that regroups or contracts them makes the errors wrong; the features choose what is to stop it.

#ifdef HAS_GPU_SHADER5
#extension GL_ARB_gpu_shader5 : require
#endif
#ifdef HAS_PRECISE
#define HAS_GUARD
#endif
#ifdef HAS_UNIT
#define HAS_GUARD
#endif

uniform sampler2D u_pairs; // red and green: a and b
out vec4 o_exact;          // sum, its error, product, its error

#include "shared/constants.glsl"
#include "kernel/exact.glsl"

#ifdef HAS_GUARD
const float KNOWN = 0.28;
uniform uint u_zero; // never set, and so 0: only the compiler does not know it
#endif

void main()
{
    vec2 pair = texelFetch(u_pairs, ivec2(gl_FragCoord.xy), 0).xy;
    o_exact = vec4(twoSum(pair.x, pair.y), twoProduct(pair.x, pair.y));
#ifdef HAS_GUARD
    // With an operand that the compiler knows it may regroup what it otherwise must leave: the error is made wrong then.
    float unknown = uintBitsToFloat(floatBitsToUint(KNOWN) ^ u_zero);
    o_exact.y += twoSum(pair.x, KNOWN) == twoSum(pair.x, unknown) ? 0.0 : 1.0;
    o_exact.w += twoProduct(pair.x, KNOWN) == twoProduct(pair.x, unknown) ? 0.0 : 1.0;
#endif
}
