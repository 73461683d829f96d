// A ray on its way through the tree, with what it carries.

struct Path {
    Ray ray;
    vec3 weight; // throughput: what of its radiance reaches the eye
#ifdef HAS_PICTURES
    float travelled; // metres from the eye, for the footprint on pictures
#endif
#ifdef HAS_ABSORPTION
    int medium; // index of the material that it runs through, -1 for air
#endif
#ifdef HAS_DEPTH_LIMIT
    int bounces;
#endif
};

// What a path's weight is worth in choosing and cutting: its largest channel.
float priority(Path path)
{
    return max(path.weight.x, max(path.weight.y, path.weight.z));
}

// Whether a path is worth a ray.
bool worthTracing(Path path)
{
    return priority(path) > 0.0 && priority(path) >= u_cut_off;
}
