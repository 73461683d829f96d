// How far single precision can be trusted: in place of light, the uncertainty of where the paths of a sample meet surfaces,
// against the size of what they meet. Paths that weigh less than TRUSTED_WEIGHT do not count.

// 0 on what is flat.
float curvatureOf(int kind, Shape shape, bool cap)
{
    bool round = kind == KIND_SPHERE || ((kind == KIND_OPEN_CYLINDER || kind == KIND_CAPPED_CYLINDER) && !cap);
    return round ? 1.0 / shape.anchor.w : 0.0;
}

// The reference length of a shape: what |o - r| + s of its kernel's rounding takes for s.
float extentOf(int kind, Shape shape)
{
    float extent = kind == KIND_PLANE ? 0.0 : shape.anchor.w;
    extent = kind == KIND_OPEN_CYLINDER || kind == KIND_CAPPED_CYLINDER ? extent + shape.axis.w : extent;
    return kind == KIND_RECTANGLE || kind == KIND_TRIANGLE ? shape.along_u.w + shape.along_v.w : extent;
}

// The smallest thing to see of an object: its radius, shortest edge or pattern; FAR_AWAY on an endless plain plane.
float detailOf(int kind, Shape shape, Material material)
{
    float detail = kind == KIND_PLANE ? FAR_AWAY : shape.anchor.w;
    float edges = min(shape.along_u.w, shape.along_v.w);
    float third = length(shape.along_u.xyz - shape.along_v.xyz);
    detail = kind == KIND_RECTANGLE ? edges : detail;
    detail = kind == KIND_TRIANGLE ? min(edges, third) : detail;
    return material.checker.w > 0.0 ? min(detail, material.checker.w) : detail;
}

// Metres by which rounding may move a crossing across its ray. A kernel that was chosen for precision loses no more than the
// way to the surface does; yet a pattern is laid out from the shape's anchor, however far that is.
float crossingRounding(Ray ray, Nearest hit, int kind, Shape shape, Material material)
{
    vec3 place = ray.origin + hit.t * ray.direction;
    float pattern = material.checker.w > 0.0 ? length(place - shape.anchor.xyz) : 0.0;
    float fine = hit.t + pattern;
    float plain = length(ray.origin - shape.anchor.xyz) + extentOf(kind, shape);
    return SINGLE_ROUNDOFF * ((hasOwnKernel(hit.object) ? fine : plain) + length(place));
}

// What a hit says of trust, as result.x: 1 beyond it, else 0; y: bits of 24 that are lost of the place.
vec3 trustAt(Path path, float across, float cosine, float detail)
{
    float share = abs(across) / (cosine * detail);
    bool counts = priority(path) >= TRUSTED_WEIGHT && detail < FAR_AWAY;
    // No number, where infinite uncertainties met, is beyond trust too.
    bool trusted = share <= TRUSTED_SHARE;
    float bits = trusted ? max(24.0 + log2(max(share, SINGLE_ROUNDOFF)), 0.0) : 24.0;
    return counts ? vec3(trusted ? 0.0 : 1.0, bits, 0.0) : vec3(0.0);
}
