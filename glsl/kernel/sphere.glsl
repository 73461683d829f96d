// Ray and sphere; the direction is unit.
// Haines, Guenther, Akenine-Moeller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, ch. 7, with
// the second root from the product of both.

Span sphereSpan(Ray ray, vec3 centre, float radius)
{
    vec3 f = ray.origin - centre;
    float b = -dot(f, ray.direction);
    // The line's point nearest to the centre, in the centre's frame.
    vec3 h = f + b * ray.direction;
    float discriminant = radius * radius - dot(h, h);
    float halfChord = sqrt(max(discriminant, 0.0));
    // The root of larger size has no cancellation; the other follows from their product.
    float larger = b >= 0.0 ? b + halfChord : b - halfChord;
    float smaller = larger == 0.0 ? 0.0 : (dot(f, f) - radius * radius) / larger;
    Span span;
    span.found = discriminant >= 0.0;
    span.near = min(smaller, larger);
    span.far = max(smaller, larger);
    return span;
}

Crossing sphereCrossing(Ray ray, int object, vec3 centre, float radius)
{
    return firstOfSpan(sphereSpan(ray, centre, radius), ray, object);
}
