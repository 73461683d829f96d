// Ray and cylinder, open or capped. `axis` is unit and runs from the base along `height`.

// The line's stretch inside the infinite cylinder. With m = d x axis the distance of line and axis is |f.m| / |m|; the
// half-chord is factored like the sphere's. A line parallel to the axis is inside for ever or never.
Span sideSpan(Ray ray, vec3 base, vec3 axis, float radius)
{
    vec3 f = ray.origin - base;
    vec3 m = cross(ray.direction, axis);
    vec3 g = cross(f, axis);
    float mm = dot(m, m);
    float fromAxis = dot(g, g) - radius * radius;
    Span span;
    if (mm == 0.0) {
        span.found = fromAxis <= 0.0;
        span.near = -FAR_AWAY;
        span.far = FAR_AWAY;
    } else {
        float b = -dot(g, m) / mm;
        float distanceToAxis = abs(dot(f, m)) / sqrt(mm);
        float discriminant = (radius - distanceToAxis) * (radius + distanceToAxis);
        float halfChord = sqrt(max(discriminant, 0.0) / mm);
        float larger = b >= 0.0 ? b + halfChord : b - halfChord;
        float smaller = larger == 0.0 ? 0.0 : fromAxis / (mm * larger);
        span.found = discriminant >= 0.0;
        span.near = b >= 0.0 ? smaller : larger;
        span.far = b >= 0.0 ? larger : smaller;
    }
    return span;
}

// The line's stretch between the planes of both caps.
Span slabSpan(Ray ray, vec3 base, vec3 axis, float height)
{
    float z = dot(ray.origin - base, axis);
    float dz = dot(ray.direction, axis);
    Span span;
    if (dz == 0.0) {
        span.found = z >= 0.0 && z <= height;
        span.near = -FAR_AWAY;
        span.far = FAR_AWAY;
    } else {
        float toBase = -z / dz;
        float toTop = (height - z) / dz;
        span.found = true;
        span.near = min(toBase, toTop);
        span.far = max(toBase, toTop);
    }
    return span;
}

// The capped cylinder is where both spans overlap, so side and caps meet at the rim without a gap.
Span cappedCylinderSpan(Ray ray, vec3 base, vec3 axis, float radius, float height)
{
    Span side = sideSpan(ray, base, axis, radius);
    Span slab = slabSpan(ray, base, axis, height);
    Span span;
    span.near = max(side.near, slab.near);
    span.far = min(side.far, slab.far);
    span.found = side.found && slab.found && span.near <= span.far;
    return span;
}

Crossing cappedCylinderCrossing(Ray ray, int object, vec3 base, vec3 axis, float radius, float height)
{
    return firstOfSpan(cappedCylinderSpan(ray, base, axis, radius, height), ray, object);
}

// An open cylinder is a wall without ends: the near wall if the ray meets it between the ends, else the far wall, seen
// through an end.
Crossing openCylinderCrossing(Ray ray, int object, vec3 base, vec3 axis, float radius, float height)
{
    Span side = sideSpan(ray, base, axis, radius);
    float z = dot(ray.origin - base, axis);
    float dz = dot(ray.direction, axis);
    float zNear = z + side.near * dz;
    float zFar = z + side.far * dz;
    bool startsWithin = ray.from == 2 * object + 1;
    bool outer = side.found && side.near > 0.0 && !startsWithin && zNear >= 0.0 && zNear <= height;
    bool inner = (startsWithin || (side.found && side.far > 0.0)) && zFar >= 0.0 && zFar <= height;
    Crossing crossing;
    crossing.found = (outer || inner) && ray.from != 2 * object;
    crossing.t = outer ? side.near : max(side.far, 0.0);
    crossing.inside = !outer;
    return crossing;
}

// The outward unit normal of the side where the ray enters (or, for `far`, leaves) the infinite cylinder.
vec3 sideNormal(Ray ray, vec3 base, vec3 axis, float radius, bool far)
{
    Span side = sideSpan(ray, base, axis, radius);
    vec3 g = (ray.origin - base) + (far ? side.far : side.near) * ray.direction;
    return normalize(g - dot(g, axis) * axis);
}

// The outward unit normal of a capped cylinder: a cap's where the slab bounds the span, the side's elsewhere.
vec3 cappedCylinderNormal(Ray ray, vec3 base, vec3 axis, float radius, float height, bool far)
{
    Span side = sideSpan(ray, base, axis, radius);
    Span slab = slabSpan(ray, base, axis, height);
    bool onCap = far ? slab.far < side.far : slab.near > side.near;
    bool onTop = (dot(ray.direction, axis) > 0.0) == far;
    return onCap ? (onTop ? axis : -axis) : sideNormal(ray, base, axis, radius, far);
}
