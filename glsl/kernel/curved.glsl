// Sphere and cylinder of huge radius, by curvature, as lens designers trace them: from the surface point nearest to the scene
// origin, the normal there and kappa = 1 / radius, all three from the host in double precision. Spencer and Murty, "General
// ray-tracing procedure", Journal of the Optical Society of America 52 (1962). No centre enters, whose distance would swallow
// the digits of what is near.

// The roots of A t^2 + B t + C = 0, sorted; a line that touches nothing is not found.
Span spanOfQuadratic(float A, float B, float C)
{
    vec2 discriminant = productDifference(B, B, 4.0 * A, C);
    float reach = discriminant.x + discriminant.y;
    float q = -0.5 * (B + (B >= 0.0 ? 1.0 : -1.0) * sqrt(max(reach, 0.0)));
    float one = q / (A == 0.0 ? 1.0 : A);
    float other = C / (q == 0.0 ? 1.0 : q);
    // A = 0: a plane, whose other side is at no distance. q = 0: both roots are 0.
    float first = q == 0.0 ? 0.0 : other;
    float second = A == 0.0 ? (B < 0.0 ? FAR_AWAY : -FAR_AWAY) : one;
    // A = B = 0: along a cylinder's axis, within for ever or never.
    bool parallel = A == 0.0 && B == 0.0;
    Span span;
    span.found = parallel ? C <= 0.0 : reach >= 0.0;
    span.near = parallel ? -FAR_AWAY : min(first, second);
    span.far = parallel ? FAR_AWAY : max(first, second);
    return span;
}

// w: the ray's origin less the surface point; f(p) = kappa |p|^2 / 2 + n . p is 0 on the surface and negative within. The
// vectors that bend are w and the direction on a sphere, their parts across the axis on a cylinder.
Span curvedSpan(vec3 w, vec3 direction, vec3 bending_w, vec3 bending_direction, FineVector normal, float kappa)
{
    vec2 slope = fineDot(fineVector(direction, vec3(0.0)), normal);
    vec2 height = fineDot(fineVector(w, vec3(0.0)), normal);
    float A = 0.5 * kappa * dot(bending_direction, bending_direction);
    float B = kappa * dot(bending_w, bending_direction) + (slope.x + slope.y);
    float C = 0.5 * kappa * dot(bending_w, bending_w) + (height.x + height.y);
    return spanOfQuadratic(A, B, C);
}

Span curvedSphereSpan(Ray ray, vec3 point, FineVector normal, float kappa)
{
    vec3 w = ray.origin - point;
    return curvedSpan(w, ray.direction, w, ray.direction, normal, kappa);
}

// The normal is at right angles to the unit axis, so that the linear terms need no projection.
Span curvedSideSpan(Ray ray, vec3 point, FineVector normal, float kappa, vec3 axis)
{
    vec3 w = ray.origin - point;
    vec3 d = ray.direction;
    return curvedSpan(w, d, w - dot(w, axis) * axis, d - dot(d, axis) * axis, normal, kappa);
}

// The outward normal at an offset from the surface point; across the axis for a cylinder.
vec3 curvedNormal(vec3 offset, vec3 normal, float kappa)
{
    return normalize(normal + kappa * offset);
}
