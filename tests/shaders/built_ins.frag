#version 300 es
// Built-ins and declarations of GLSL ES 3.00.
// expect: 0,0 = 0.5 1 0.75
precision highp float;
precision highp int;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    uint halves = packHalf2x16(vec2(0.5, 0.75));
    vec2 back = unpackHalf2x16(halves);
    fragColor = vec4(back.x, uintBitsToFloat(floatBitsToUint(1.0)), back.y, 1.0);
}
