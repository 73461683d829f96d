// The ray tree, depth first: a ray is followed to its end before what split off on the way is taken up, the newest first.
// Nothing is dropped but by budget, cut-off and depth; yet a deep branch may eat the budget of all others.

// Radiance (rgb) and the number of rays traced (a).
vec4 traceDepthFirst(Path eye)
{
    // Each ray traced takes one place and leaves two at most: there is room for all that the budget may reach.
    Path stack[QUEUE_SLOTS];
    stack[0] = eye;
    int waiting = 1;
    vec4 sum = vec4(0.0);
    for (int traced = 0; traced < u_budget && waiting > 0; ++traced) {
        waiting -= 1;
        Scatter found = scatter(stack[waiting]);
        sum = gathered(sum, found);
        Path next = found.reflected;
#ifdef HAS_REFRACTION
        // Of a surface's two rays the heavier goes on, the reflected one where they weigh the same; the other waits below.
        bool through = priority(found.refracted) > priority(found.reflected);
        next = chosen(through, found.refracted, found.reflected);
        Path later = chosen(through, found.reflected, found.refracted);
        if (waiting < QUEUE_SLOTS && worthTracing(later)) {
            stack[waiting] = later;
            waiting += 1;
        }
#ifdef HAS_LOST_WEIGHT
        else
            sum.z += weightOfWaiting(later);
#endif
#endif
        if (waiting < QUEUE_SLOTS && worthTracing(next)) {
            stack[waiting] = next;
            waiting += 1;
        }
#ifdef HAS_LOST_WEIGHT
        else
            sum.z += weightOfWaiting(next);
#endif
    }
#ifdef HAS_LOST_WEIGHT
    for (int i = 0; i < waiting; ++i)
        sum.z += weightOfWaiting(stack[i]);
#endif
    return sum;
}
