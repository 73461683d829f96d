// While the button is held since this frame, z and w are the place of the click.
// options: --mouse 2,3,down
// expect: 0,0 = 0.25 0.375 0.25
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(iMouse.xy / 8.0, iMouse.w > 0.0 ? iMouse.z / 8.0 : 0.0, 1.0);
}
