// The ray tree, generation by generation: nothing is dropped but by budget, cut-off and depth. The order to measure
// others against.

// Radiance (rgb) and the number of rays traced (a).
vec4 traceBreadthFirst(Path eye)
{
    Path queue[QUEUE_SLOTS];
    queue[0] = eye;
    int waiting = 1;
    vec4 sum = vec4(0.0);
    for (int traced = 0; traced < waiting && traced < u_budget; ++traced) {
        Scatter found = scatter(queue[traced]);
        sum = gathered(sum, found);
        if (waiting < u_budget && worthTracing(found.reflected)) {
            queue[waiting] = found.reflected;
            waiting += 1;
        }
#ifdef HAS_LOST_WEIGHT
        // A place for each ray of the budget: what finds the queue full would never be traced.
        else
            sum.z += weightOfWaiting(found.reflected);
#endif
#ifdef HAS_REFRACTION
        if (waiting < u_budget && worthTracing(found.refracted)) {
            queue[waiting] = found.refracted;
            waiting += 1;
        }
#ifdef HAS_LOST_WEIGHT
        else
            sum.z += weightOfWaiting(found.refracted);
#endif
#endif
    }
    return sum;
}
