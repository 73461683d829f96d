// Values from comments behind uniforms; --set and a declaration's own value go before them.
// options: --set u_set=0.5
// expect: 0,0 = 0.25 0.5 0.75
// expect: 5,0 = 1.0 0.5333333 0.0
uniform float u_left; // 0.25 [0, 1] what the left side is
uniform float u_set; // 0.1
uniform float u_own = 0.75; // 0.2 [0, 1]
uniform vec3 u_tint; // #ff8800 of the right side
uniform int u_side; // 4 [1, 8] pixels
uniform bool u_both; // true
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(u_left, u_set, u_own, 1.0);
    if (u_both && fragCoord.x > float(u_side))
        fragColor = vec4(u_tint, 1.0);
}
