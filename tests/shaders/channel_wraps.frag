// Right of the picture: repeated it starts anew, clamped its last column goes on, mirrored it runs back.
// options: --channel0 'quarters.png?filter=nearest' --channel1 'quarters.png?filter=nearest&wrap=clamp' --channel3 'quarters.png?filter=nearest&wrap=mirror'
// expect: 0,0 = 0 1 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 right = vec2(1.25, 0.25), farther = vec2(1.75, 0.25);
    fragColor = vec4(texture(iChannel0, right).r, texture(iChannel1, right).r, texture(iChannel3, farther).r, 1.0);
}
