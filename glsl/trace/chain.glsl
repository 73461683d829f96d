// Every surface sends on one ray at most: the tree is a chain, and needs no pool.

// Radiance (rgb) and the number of rays traced (a).
vec4 traceChain(Path eye)
{
    vec4 sum = vec4(0.0);
    Path current = eye;
    for (int traced = 0; traced < u_budget; ++traced) {
        Scatter found = scatter(current);
        sum = gathered(sum, found);
        current = found.reflected;
        if (!worthTracing(current))
            break;
    }
#ifdef HAS_LOST_WEIGHT
    sum.z += weightOfWaiting(current);
#endif
    return sum;
}
