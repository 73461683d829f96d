// Accounts of the weight that never arrives because a ray is not traced, as three sums: below the cut-off (x), fallen out of
// the pool (y), beyond the budget or the depth limit (z). A path counts by its largest channel, as everywhere in the tree.

// What is lost at once of a path that a surface sends on.
vec3 lostAtOnce(Path path)
{
    float depth = 0.0;
#ifdef HAS_DEPTH_LIMIT
    depth = path.beyond_depth;
#endif
    return vec3(worthTracing(path) ? 0.0 : priority(path), 0.0, depth);
}

// What is lost with a path that was kept, or would have been.
float weightOfWaiting(Path path)
{
    return worthTracing(path) ? priority(path) : 0.0;
}
