// Rays, and the rule by which a ray leaves the surface that it starts on without any epsilon.

// from = 2 * object + 1 starts on the inner (or back) side of that object, 2 * object on the outer (or front) side;
// -1 starts in free space. Comparing it with an object's own codes replaces every offset of the origin, so that it
// holds at any scale.
struct Ray {
    vec3 origin;    // scene frame, metres
    vec3 direction; // unit
    int from;
};

// Where a ray meets an object. `found` is the only sign of a hit: no value of t or of a normal stands for a miss.
struct Crossing {
    bool found;
    float t;     // along the direction, metres, >= 0
    bool inside; // met from within a solid, or from behind a flat shape
    bool cap;    // met on a flat end of a solid that is round elsewhere
};

// Where a line is inside a convex solid: near <= far, signed, along the direction.
struct Span {
    bool found;
    float near;
    float far;
};

// The first surface that a ray meets on the solid that it crosses along `span`. A ray that left the solid never meets it
// again; one that starts on its inner side always meets the far wall, however short the chord.
Crossing firstOfSpan(Span span, Ray ray, int object)
{
    bool startsWithin = ray.from == 2 * object + 1;
    bool enters = span.near > 0.0 && !startsWithin;
    Crossing crossing;
    crossing.t = enters ? span.near : max(span.far, 0.0);
    crossing.inside = !enters;
    crossing.cap = false;
    crossing.found = (startsWithin || (span.found && span.far > 0.0)) && ray.from != 2 * object;
    return crossing;
}

// The same for a sphere. From its inner side one root is 0, so that the other is the sum of both: a glancing chord, which the
// square root has lost, keeps its digits.
Crossing firstOfRoundSpan(Span span, Ray ray, int object)
{
    Crossing crossing = firstOfSpan(span, ray, object);
    crossing.t = ray.from == 2 * object + 1 ? max(span.near + span.far, 0.0) : crossing.t;
    return crossing;
}

// The same for a solid that no ray is ever within: it lets no light through, and the eye is outside.
Crossing entryOfSpan(Span span, Ray ray, int object)
{
    Crossing crossing;
    crossing.found = span.found && span.near > 0.0 && ray.from != 2 * object;
    crossing.t = span.near;
    crossing.inside = false;
    crossing.cap = false;
    return crossing;
}
