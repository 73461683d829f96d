// Ray and round shapes by curvature: the crossings, and the place and normal of a hit, for objects that are huge against the
// way to them. The point and its normal are those of curved.glsl.

Crossing curvedSphereCrossing(Ray ray, int object, vec3 point, FineVector normal, float kappa)
{
    return firstOfRoundSpan(curvedSphereSpan(ray, point, normal, kappa), ray, object);
}

Crossing curvedSphereEntry(Ray ray, int object, vec3 point, FineVector normal, float kappa)
{
    return entryOfSpan(curvedSphereSpan(ray, point, normal, kappa), ray, object);
}

vec3 curvedSphereNormal(vec3 place, vec3 point, FineVector normal, float kappa)
{
    return curvedNormal(place - point, normal.high, kappa);
}

// The place brought back onto the surface, along the normal.
vec3 onCurvedSphere(vec3 place, vec3 outward, vec3 point, FineVector normal, float kappa)
{
    vec3 w = place - point;
    vec2 height = fineDot(fineVector(w, vec3(0.0)), normal);
    return place - (0.5 * kappa * dot(w, w) + (height.x + height.y)) * outward;
}

// `above` is the point's height above the base; the axis is unit.
Span curvedEndsSpan(Ray ray, vec3 point, vec3 axis, float height, float above)
{
    float z = dot(ray.origin - point, axis) + above;
    return spanBetween(z, dot(ray.direction, axis), height);
}

Span curvedCappedCylinderSpan(Ray ray, vec3 point, FineVector normal, float kappa, vec3 axis, float height, float above)
{
    return commonSpan(curvedSideSpan(ray, point, normal, kappa, axis), curvedEndsSpan(ray, point, axis, height, above));
}

Crossing curvedCappedCylinderCrossing(Ray ray, int object, vec3 point, FineVector normal, float kappa, vec3 axis,
                                      float height, float above)
{
    return firstOfCapped(curvedSideSpan(ray, point, normal, kappa, axis),
                         curvedEndsSpan(ray, point, axis, height, above), ray, object);
}

Crossing curvedCappedCylinderEntry(Ray ray, int object, vec3 point, FineVector normal, float kappa, vec3 axis,
                                   float height, float above)
{
    return entryOfCapped(curvedSideSpan(ray, point, normal, kappa, axis),
                         curvedEndsSpan(ray, point, axis, height, above), ray, object);
}

Crossing curvedOpenCylinderCrossing(Ray ray, int object, vec3 point, FineVector normal, float kappa, vec3 axis,
                                    float height, float above)
{
    return firstOfOpen(curvedSideSpan(ray, point, normal, kappa, axis), curvedEndsSpan(ray, point, axis, height, above),
                       ray, object);
}

// On the side; the ends' normal is the axis.
vec3 curvedSideNormal(vec3 place, vec3 point, FineVector normal, float kappa, vec3 axis)
{
    vec3 offset = place - point;
    return curvedNormal(offset - dot(offset, axis) * axis, normal.high, kappa);
}
