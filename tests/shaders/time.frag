// At 2 s of 60 frames a second: frame 120.
// options: --time 2
// expect: 0,0 = 0.5 0.5 0.5
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(iTime / 4.0, iTimeDelta * iFrameRate / 2.0, float(iFrame) / 240.0, 1.0);
    if (iGlobalTime != iTime || iChannelTime[2] != iTime)
        fragColor = vec4(0.0);
}
