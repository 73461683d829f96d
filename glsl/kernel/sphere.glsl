// Ray and sphere.
// Haines, Guenther, Akenine-Moeller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, ch. 7,
// with the discriminant in factored form (pbrt-v4) and the second root from the product of both.

Span sphereSpan(Ray ray, vec3 centre, float radius)
{
    float dd = dot(ray.direction, ray.direction);
    vec3 f = ray.origin - centre;
    float b = -dot(f, ray.direction) / dd;
    // The line's point nearest to the centre, in the centre's frame.
    vec3 h = f + b * ray.direction;
    float distanceToLine = length(h);
    float discriminant = (radius - distanceToLine) * (radius + distanceToLine);
    float halfChord = sqrt(max(discriminant, 0.0) / dd);
    // The root of larger size has no cancellation; the other follows from their product.
    float larger = b >= 0.0 ? b + halfChord : b - halfChord;
    float smaller = larger == 0.0 ? 0.0 : (dot(f, f) - radius * radius) / (dd * larger);
    Span span;
    span.found = discriminant >= 0.0;
    span.near = b >= 0.0 ? smaller : larger;
    span.far = b >= 0.0 ? larger : smaller;
    return span;
}

// The outward unit normal where the ray enters (or, for `far`, leaves) the sphere: formed in the centre's frame, never as
// the difference of two world positions.
vec3 sphereNormal(Ray ray, vec3 centre, float radius, bool far)
{
    float dd = dot(ray.direction, ray.direction);
    vec3 f = ray.origin - centre;
    vec3 h = f - (dot(f, ray.direction) / dd) * ray.direction;
    float distanceToLine = length(h);
    float halfChord = sqrt(max((radius - distanceToLine) * (radius + distanceToLine), 0.0) / dd);
    return normalize(h + (far ? halfChord : -halfChord) * ray.direction);
}

Crossing sphereCrossing(Ray ray, int object, vec3 centre, float radius)
{
    return firstOfSpan(sphereSpan(ray, centre, radius), ray, object);
}
