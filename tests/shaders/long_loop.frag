// A loop that comes near to where software drivers end loops, and ends by itself: as many iterations as it says.
// expect: 1,2 = 0.9155273438 0.5 1
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    uint state = 1u;
    int ran = 0;
    while (ran < 60000) {
        state = 1664525u * state + 1013904223u;
        ++ran;
        if (state == 0u)
            break;
    }
    fragColor = vec4(float(ran) / 65536.0, 0.5, 1.0, 1.0);
}
