// A pointer that was never there.
// expect: 0,0 = 1 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = iMouse == vec4(0.0) ? vec4(1.0, 0.0, 0.0, 1.0) : vec4(0.0);
}
