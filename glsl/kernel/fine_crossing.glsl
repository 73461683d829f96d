// Ray and shapes by compensated arithmetic: the crossings, and the place and normal of a hit, for objects whose rounding would
// show. A point comes as the float nearest to it and what that lost.

FineVector fineFrom(FineVector point, vec3 place)
{
    return fineDifference(place, point.high, point.low);
}

FineVector fineTowards(FineVector point, vec3 place)
{
    FineVector from = fineFrom(point, place);
    return fineVector(-from.high, -from.low);
}

// The rounded direction is the ray's own: nothing was lost.
FineVector fineDirection(Ray ray)
{
    return fineVector(ray.direction, vec3(0.0));
}

Span fineSphereSpan(Ray ray, FineVector centre, float radius)
{
    return fineSphereChord(fineFrom(centre, ray.origin), fineDirection(ray), radius).span;
}

Crossing fineSphereCrossing(Ray ray, int object, FineVector centre, float radius)
{
    return firstOfRoundSpan(fineSphereSpan(ray, centre, radius), ray, object);
}

Crossing fineSphereEntry(Ray ray, int object, FineVector centre, float radius)
{
    return entryOfSpan(fineSphereSpan(ray, centre, radius), ray, object);
}

vec3 fineSphereNormal(vec3 place, FineVector centre)
{
    return normalize(fineFrom(centre, place).high);
}

// The place brought back onto the surface, along the normal.
vec3 onFineSphere(vec3 place, vec3 outward, FineVector centre, float radius)
{
    FineVector f = fineFrom(centre, place);
    vec2 power = fineSum(fineDot(f, f), -twoProduct(radius, radius));
    return place - (power.x + power.y) / (2.0 * radius) * outward;
}

// The axis' length is the cylinder's height.
Span fineSideSpan(Ray ray, FineVector base, FineVector axis, float radius)
{
    return fineSideChord(fineFrom(base, ray.origin), fineDirection(ray), axis, radius).span;
}

Span fineEndsSpan(Ray ray, FineVector base, FineVector axis)
{
    return fineSlabSpan(fineFrom(base, ray.origin), fineDirection(ray), axis);
}

Span fineCappedCylinderSpan(Ray ray, FineVector base, FineVector axis, float radius)
{
    return commonSpan(fineSideSpan(ray, base, axis, radius), fineEndsSpan(ray, base, axis));
}

Crossing fineCappedCylinderCrossing(Ray ray, int object, FineVector base, FineVector axis, float radius)
{
    return firstOfCapped(fineSideSpan(ray, base, axis, radius), fineEndsSpan(ray, base, axis), ray, object);
}

Crossing fineCappedCylinderEntry(Ray ray, int object, FineVector base, FineVector axis, float radius)
{
    return entryOfCapped(fineSideSpan(ray, base, axis, radius), fineEndsSpan(ray, base, axis), ray, object);
}

Crossing fineOpenCylinderCrossing(Ray ray, int object, FineVector base, FineVector axis, float radius)
{
    return firstOfOpen(fineSideSpan(ray, base, axis, radius), fineEndsSpan(ray, base, axis), ray, object);
}

// On the side; the ends' normal is the axis. What lies along it is taken off twice: the second step brings the rest from the
// accuracy of |f| to that of the radius, without which rays along a mirror wall would drift.
vec3 fineSideNormal(vec3 place, FineVector base, FineVector axis)
{
    FineVector f = fineFrom(base, place);
    vec2 along = fineDot(f, axis);
    float perSquare = 1.0 / dot(axis.high, axis.high);
    vec3 radial = fineStep(f, -(along.x + along.y) * perSquare, axis).high;
    return normalize(radial - dot(radial, axis.high) * perSquare * axis.high);
}

Crossing finePlaneCrossing(Ray ray, int object, FineVector point, FineVector normal)
{
    PlaneRoot root = finePlaneRoot(fineTowards(point, ray.origin), fineDirection(ray), normal);
    Crossing crossing;
    crossing.t = root.t;
    crossing.inside = root.approach > 0.0;
    crossing.cap = false;
    crossing.found =
        root.approach != 0.0 && root.t > 0.0 && ray.from != 2 * object && ray.from != 2 * object + 1;
    return crossing;
}

Crossing fineDiskCrossing(Ray ray, int object, FineVector centre, FineVector normal, float radius)
{
    Crossing crossing = finePlaneCrossing(ray, object, centre, normal);
    crossing.found = crossing.found && fineWithinDisk(fineTowards(centre, ray.origin), fineDirection(ray), crossing.t, radius);
    return crossing;
}

Crossing fineRectangleCrossing(Ray ray, int object, FineVector corner, FineVector normal, vec3 along_u, vec3 along_v)
{
    Crossing crossing = finePlaneCrossing(ray, object, corner, normal);
    crossing.found = crossing.found && fineWithinRectangle(fineTowards(corner, ray.origin), fineDirection(ray), crossing.t,
                                                           along_u, along_v);
    return crossing;
}

Crossing fineTriangleCrossing(Ray ray, int object, FineVector a, FineVector b, FineVector c, FineVector normal)
{
    Crossing crossing = finePlaneCrossing(ray, object, a, normal);
    vec3 sides = fineTriangleSides(fineDirection(ray), fineTowards(a, ray.origin), fineTowards(b, ray.origin),
                                   fineTowards(c, ray.origin));
    crossing.found = crossing.found && allOfOneSign(sides);
    return crossing;
}

float fineHeight(vec3 place, FineVector point, FineVector normal)
{
    vec2 height = fineDot(fineFrom(point, place), normal);
    return height.x + height.y;
}

// The place brought back into the plane.
vec3 onFinePlane(vec3 place, FineVector point, FineVector normal)
{
    return place - fineHeight(place, point, normal) * normal.high;
}
