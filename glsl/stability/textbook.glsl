// The formulas that textbooks print, for the stability suite to hold ours against. No picture is made with them.

// The quadratic a t^2 + 2 b t + c = 0 by its schoolbook formula.
Span textbookRoots(float a, float b, float c)
{
    float discriminant = b * b - a * c;
    float root = sqrt(max(discriminant, 0.0));
    Span span;
    span.found = discriminant >= 0.0;
    span.near = (-b - root) / a;
    span.far = (-b + root) / a;
    return span;
}

Span textbookSphere(vec3 origin, vec3 direction, vec3 centre, float radius)
{
    vec3 f = origin - centre;
    return textbookRoots(dot(direction, direction), dot(f, direction), dot(f, f) - radius * radius);
}

// The infinite cylinder about a unit axis: the sphere's equation across it.
Span textbookSide(vec3 origin, vec3 direction, vec3 base, vec3 axis, float radius)
{
    vec3 f = origin - base;
    vec3 across_f = f - dot(f, axis) * axis;
    vec3 across_d = direction - dot(direction, axis) * axis;
    return textbookRoots(dot(across_d, across_d), dot(across_f, across_d), dot(across_f, across_f) - radius * radius);
}

float textbookPlane(vec3 origin, vec3 direction, vec3 point, vec3 normal)
{
    return dot(point - origin, normal) / dot(direction, normal);
}

// Moeller and Trumbore, "Fast, minimum storage ray/triangle intersection", Journal of Graphics Tools 2 (1997), with its
// epsilon. x: t, y and z: shares of b and c; w: 1 where the determinant is not taken for 0.
vec4 textbookTriangle(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c)
{
    vec3 p = cross(direction, c - a);
    float determinant = dot(b - a, p);
    vec3 s = origin - a;
    vec3 q = cross(s, b - a);
    float inverse = 1.0 / determinant;
    return vec4(dot(c - a, q) * inverse, dot(s, p) * inverse, dot(direction, q) * inverse,
                abs(determinant) > 1.0e-6 ? 1.0 : 0.0);
}
