// How far a driver lets loops run. Each pixel runs two loops, one after the other, and says how many iterations each took:
// software drivers end loops silently. The step is a linear congruential generator, which no compiler folds into a
// formula, and its state proves that the iterations were run.

uniform ivec2 u_limits; // iterations of the first and of the second loop

out vec4 o_ran; // iterations of the first and of the second loop; state, upper and lower 16 bits

uint advanced(uint state)
{
    return 1664525u * state + 1013904223u;
}

void main()
{
    uint state = 1u;
    ivec2 ran = ivec2(0);
#ifdef HAS_TURNS
    // The pixels of a row of eight loop one after the other: while one does, its neighbours wait.
    for (int turn = 0; turn < 8; ++turn) {
        int limit = turn == int(gl_FragCoord.x) ? u_limits.x : 0;
#else
    {
        int limit = u_limits.x;
#endif
        for (int i = 0; i < limit; ++i) {
            state = advanced(state);
            ++ran.x;
        }
    }
    for (int i = 0; i < u_limits.y; ++i) {
        state = advanced(state);
        ++ran.y;
    }
    o_ran = vec4(vec2(ran), float(state >> 16), float(state & 65535u));
}
