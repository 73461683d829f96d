// Pixel centres, from the lower left corner.
// expect: 2,1 = 0.3125 0.375 1
// expect: 7,3 = 0.9375 0.875 1
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 uv = fragCoord / iResolution.xy;
    fragColor = vec4(uv, iResolution.z, 0.0);
}
