// A picture's lowest row is t = 0, as Shadertoy flips it; bytes are not decoded.
// options: --channel0 'quarters.png?filter=nearest'
// expect: 0,0 = 0 0 0.2
// expect: 7,0 = 1 0 0.2
// expect: 0,3 = 0 1 0.2
// expect: 4,2 = 1 1 0.2
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = texture(iChannel0, fragCoord / iResolution.xy);
    if (iChannelResolution[0] != vec3(2.0, 2.0, 1.0) || iChannelResolution[1].x != 0.0)
        fragColor = vec4(0.0);
}
