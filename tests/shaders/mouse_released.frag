// Released, xy hold and zw are negative.
// options: --mouse 2,3
// expect: 0,0 = 0.25 0.25 0.375
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(iMouse.x, -iMouse.zw, 8.0) / 8.0;
}
