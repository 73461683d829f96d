// options: --channel2 'quarters.png?filter=nearest&flip=no'
// expect: 0,0 = 0 1 0.2
// expect: 7,3 = 1 0 0.2
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = texture(iChannel2, fragCoord / iResolution.xy);
}
