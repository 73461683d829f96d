// Half-way between two texels, and the mean of all four at the coarsest level.
// options: --channel0 'quarters.png?filter=linear' --channel1 quarters.png
// expect: 0,0 = 0.5 0.5 0.2 within 0.003
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(texture(iChannel0, vec2(0.5, 0.25)).r, textureLod(iChannel1, vec2(0.9), 1.0).g,
                     textureLod(iChannel1, vec2(0.1), 1.0).b, 1.0);
}
