// Ray and cylinder, open or capped. The ray's direction and `axis` are unit vectors; `axis` runs from the base along `height`.

// The line's stretch inside the infinite cylinder. With m = d x axis the distance of line and axis is |f.m| / |m|. A line
// parallel to the axis is inside for ever or never.
Span sideSpan(Ray ray, vec3 base, vec3 axis, float radius)
{
    vec3 f = ray.origin - base;
    vec3 m = cross(ray.direction, axis);
    vec3 g = cross(f, axis);
    float mm = dot(m, m);
    float fromAxis = dot(g, g) - radius * radius;
    bool parallel = mm == 0.0;
    float perMm = 1.0 / (parallel ? 1.0 : mm);
    float b = -dot(g, m) * perMm;
    float fm = dot(f, m);
    float discriminant = radius * radius - fm * fm * perMm;
    float halfChord = sqrt(max(discriminant, 0.0) * perMm);
    float larger = b >= 0.0 ? b + halfChord : b - halfChord;
    float smaller = larger == 0.0 ? 0.0 : fromAxis * perMm / larger;
    Span span;
    span.found = parallel ? fromAxis <= 0.0 : discriminant >= 0.0;
    span.near = parallel ? -FAR_AWAY : min(smaller, larger);
    span.far = parallel ? FAR_AWAY : max(smaller, larger);
    return span;
}

// The line's stretch between the planes of both caps: z is the origin's height above the base, dz the direction's part along
// the axis.
Span spanBetween(float z, float dz, float height)
{
    bool parallel = dz == 0.0;
    float perDz = 1.0 / (parallel ? 1.0 : dz);
    float toBase = -z * perDz;
    float toTop = (height - z) * perDz;
    Span span;
    span.found = !parallel || (z >= 0.0 && z <= height);
    span.near = parallel ? -FAR_AWAY : min(toBase, toTop);
    span.far = parallel ? FAR_AWAY : max(toBase, toTop);
    return span;
}

Span slabSpan(Ray ray, vec3 base, vec3 axis, float height)
{
    return spanBetween(dot(ray.origin - base, axis), dot(ray.direction, axis), height);
}

// The capped cylinder is where both spans overlap, so side and caps meet at the rim without a gap.
Span commonSpan(Span side, Span slab)
{
    Span span;
    span.near = max(side.near, slab.near);
    span.far = min(side.far, slab.far);
    span.found = side.found && slab.found && span.near <= span.far;
    return span;
}

Span cappedCylinderSpan(Ray ray, vec3 base, vec3 axis, float radius, float height)
{
    return commonSpan(sideSpan(ray, base, axis, radius), slabSpan(ray, base, axis, height));
}

// Where the slab bounds the span, the ray meets a cap.
Crossing firstOfCapped(Span side, Span slab, Ray ray, int object)
{
    Crossing crossing = firstOfSpan(commonSpan(side, slab), ray, object);
    crossing.cap = crossing.inside ? slab.far < side.far : slab.near > side.near;
    return crossing;
}

Crossing entryOfCapped(Span side, Span slab, Ray ray, int object)
{
    Crossing crossing = entryOfSpan(commonSpan(side, slab), ray, object);
    crossing.cap = slab.near > side.near;
    return crossing;
}

Crossing cappedCylinderCrossing(Ray ray, int object, vec3 base, vec3 axis, float radius, float height)
{
    return firstOfCapped(sideSpan(ray, base, axis, radius), slabSpan(ray, base, axis, height), ray, object);
}

Crossing cappedCylinderEntry(Ray ray, int object, vec3 base, vec3 axis, float radius, float height)
{
    return entryOfCapped(sideSpan(ray, base, axis, radius), slabSpan(ray, base, axis, height), ray, object);
}

// The first of a wall's two crossings that lies between its ends.
Crossing firstOfWall(Span side, bool nearBetween, bool farBetween, Ray ray, int object)
{
    bool startsWithin = ray.from == 2 * object + 1;
    bool outer = side.found && side.near > 0.0 && !startsWithin && nearBetween;
    bool inner = (startsWithin || (side.found && side.far > 0.0)) && farBetween;
    Crossing crossing;
    crossing.found = (outer || inner) && ray.from != 2 * object;
    crossing.t = outer ? side.near : max(side.far, 0.0);
    crossing.inside = !outer;
    crossing.cap = false;
    return crossing;
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
    return firstOfWall(side, zNear >= 0.0 && zNear <= height, zFar >= 0.0 && zFar <= height, ray, object);
}

// The same where the slab tells what lies between the ends.
Crossing firstOfOpen(Span side, Span slab, Ray ray, int object)
{
    bool nearBetween = slab.found && side.near >= slab.near && side.near <= slab.far;
    bool farBetween = slab.found && side.far >= slab.near && side.far <= slab.far;
    return firstOfWall(side, nearBetween, farBetween, ray, object);
}
