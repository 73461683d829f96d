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
#ifdef HAS_TRUST
    Blur blur; // what its origin and direction may be off by
#endif
#ifdef HAS_DEPTH_LIMIT
    int bounces;
#ifdef HAS_LOST_WEIGHT
    float beyond_depth; // weight that the depth limit took, just after the bounce alone
#endif
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

#ifdef HAS_REFRACTION
// The first where `first` holds, else the second. Selects in place of branches: software drivers run both sides of a branch,
// and pay for the branch itself on top.
Path chosen(bool first, Path a, Path b)
{
    Path result;
    result.ray.origin = first ? a.ray.origin : b.ray.origin;
    result.ray.direction = first ? a.ray.direction : b.ray.direction;
    result.ray.from = first ? a.ray.from : b.ray.from;
    result.weight = first ? a.weight : b.weight;
#ifdef HAS_PICTURES
    result.travelled = first ? a.travelled : b.travelled;
#endif
#ifdef HAS_ABSORPTION
    result.medium = first ? a.medium : b.medium;
#endif
#ifdef HAS_TRUST
    result.blur.offset = first ? a.blur.offset : b.blur.offset;
    result.blur.angle = first ? a.blur.angle : b.blur.angle;
#endif
#ifdef HAS_DEPTH_LIMIT
    result.bounces = first ? a.bounces : b.bounces;
#endif
    return result;
}
#endif
