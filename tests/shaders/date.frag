// Equal runs draw equal pictures: the date is the first day of 2026 (months count from 0), its seconds are the time.
// options: --time 3
// expect: 0,0 = 1 0.5 1
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(iDate.x / 2026.0, iDate.z / 2.0 + iDate.y, iDate.w / 3.0, iSampleRate / 44100.0);
#ifndef HW_PERFORMANCE
    fragColor = vec4(0.0);
#endif
}
