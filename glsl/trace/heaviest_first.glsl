// The ray tree, heaviest first: of all rays that wait the one that matters most is traced next. A small sorted pool is
// enough, for what falls out of it weighs least.

// Ties go to the older ray.
bool heavier(Path newer, Path older)
{
    return priority(newer) > priority(older);
}

// Radiance (rgb) and the number of rays traced (a).
vec4 traceHeaviestFirst(Path eye)
{
    // Waiting rays, the heaviest first; weight 0 marks an empty place.
    Path pool[POOL_SLOTS];
    for (int i = 0; i < POOL_SLOTS; ++i) {
        pool[i] = eye;
        pool[i].weight = vec3(0.0);
    }
    vec4 sum = vec4(0.0);
    Path current = eye;
    for (int traced = 0; traced < u_budget; ++traced) {
        Scatter found = scatter(current);
        sum = gathered(sum, found);
        bool through = heavier(found.refracted, found.reflected);
        current = chosen(through, found.refracted, found.reflected);
        Path waiting = chosen(through, found.reflected, found.refracted);
        // The pool's first and the heavier of the new rays: one is traced next, the other waits.
        bool pooled = !heavier(current, pool[0]);
        Path first = pool[0];
        pool[0] = chosen(pooled, current, first);
        current = chosen(pooled, first, current);
        if (!worthTracing(current))
            break;
        for (int i = 1; i < POOL_SLOTS; ++i) {
            bool sinks = pooled && !heavier(pool[i - 1], pool[i]);
            Path newer = pool[i - 1];
            pool[i - 1] = chosen(sinks, pool[i], newer);
            pool[i] = chosen(sinks, newer, pool[i]);
        }
        // The lighter new ray sinks to its place; what sinks out of the pool is lost.
        for (int i = 0; i < POOL_SLOTS; ++i) {
            bool takes = worthTracing(waiting) && heavier(waiting, pool[i]);
            Path lighter = pool[i];
            pool[i] = chosen(takes, waiting, lighter);
            waiting = chosen(takes, lighter, waiting);
        }
#ifdef HAS_LOST_WEIGHT
        sum.y += weightOfWaiting(waiting);
#endif
    }
#ifdef HAS_LOST_WEIGHT
    sum.z += weightOfWaiting(current);
    for (int i = 0; i < POOL_SLOTS; ++i)
        sum.z += weightOfWaiting(pool[i]);
#endif
    return sum;
}
