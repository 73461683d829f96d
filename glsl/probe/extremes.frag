// What this device makes of numbers at the edges of float. They come in as uniforms, so that no compiler computes the answers.
// Two pixels.

uniform float u_large;     // 1e20: its square is above the largest float
uniform float u_small;     // 1e-20: its square is below the smallest
uniform float u_zero;      // 0
uniform float u_tiny;      // 2^-70: its square is subnormal
uniform float u_subnormal; // 2^-130

out vec4 o_extremes;

void main()
{
    if (gl_FragCoord.x < 1.0) {
        float large = normalize(vec3(u_large, 0.0, 0.0)).x;
        float small = normalize(vec3(u_small, 0.0, 0.0)).x;
        o_extremes = vec4(large, small, atan(u_zero, u_zero), pow(u_zero, u_zero));
    } else {
        // Seen by bits: a comparison with zero may flush as well.
        bool resultKept = floatBitsToUint(u_tiny * u_tiny) != 0u;
        bool inputKept = floatBitsToUint(u_subnormal * (1.0 / (u_tiny + u_zero))) != 0u;
        o_extremes = vec4(resultKept, inputKept, 0.0, 0.0);
    }
}
