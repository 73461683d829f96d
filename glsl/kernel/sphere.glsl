// Ray and sphere; the direction is unit.
// Haines, Guenther, Akenine-Moeller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, ch. 7: the
// discriminant from the line's point nearest to the centre. Against quad precision |dt| |cos i| stays below 4.7 times
// 2^-24 (|o - c| + R), which the second root's product form brings to 4.2, and a factored discriminant no lower.

Span sphereSpan(Ray ray, vec3 centre, float radius)
{
    vec3 f = ray.origin - centre;
    float b = -dot(f, ray.direction);
    // The line's point nearest to the centre, in the centre's frame.
    vec3 h = f + b * ray.direction;
    float discriminant = radius * radius - dot(h, h);
    float halfChord = sqrt(max(discriminant, 0.0));
    Span span;
    span.found = discriminant >= 0.0;
    span.near = b - halfChord;
    span.far = b + halfChord;
    return span;
}

Crossing sphereCrossing(Ray ray, int object, vec3 centre, float radius)
{
    return firstOfRoundSpan(sphereSpan(ray, centre, radius), ray, object);
}

Crossing sphereEntry(Ray ray, int object, vec3 centre, float radius)
{
    return entryOfSpan(sphereSpan(ray, centre, radius), ray, object);
}
