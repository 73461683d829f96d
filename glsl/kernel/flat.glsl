// Ray and flat shapes: plane, disk, rectangle, triangle. `normal` is unit. A flat shape skips itself.

// Where the ray meets the infinite plane through `point`. A ray within the plane misses it.
Crossing planeCrossing(Ray ray, int object, vec3 point, vec3 normal)
{
    float approach = dot(ray.direction, normal);
    float height = dot(point - ray.origin, normal);
    Crossing crossing;
    crossing.t = height / (approach == 0.0 ? 1.0 : approach);
    crossing.inside = approach > 0.0;
    crossing.cap = false;
    crossing.found =
        approach != 0.0 && crossing.t > 0.0 && ray.from != 2 * object && ray.from != 2 * object + 1;
    return crossing;
}

Crossing diskCrossing(Ray ray, int object, vec3 centre, vec3 normal, float radius)
{
    Crossing crossing = planeCrossing(ray, object, centre, normal);
    vec3 offset = crossing.t * ray.direction - (centre - ray.origin);
    crossing.found = crossing.found && dot(offset, offset) <= radius * radius;
    return crossing;
}

// along_u and along_v map an offset from the corner to 0..1 along the edges.
Crossing rectangleCrossing(Ray ray, int object, vec3 corner, vec3 normal, vec3 along_u, vec3 along_v)
{
    Crossing crossing = planeCrossing(ray, object, corner, normal);
    vec3 offset = crossing.t * ray.direction - (corner - ray.origin);
    float u = dot(offset, along_u);
    float v = dot(offset, along_v);
    crossing.found = crossing.found && u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
    return crossing;
}

// The signed volume that the direction spans with an edge of the triangle, both ends relative to the ray's origin. Its sign
// tells the edge's side, and it is the exact negative for the neighbour that runs the edge the other way: no leaks.
float edgeSide(vec3 direction, vec3 start, vec3 end)
{
    return dot(direction, cross(end, start));
}

Crossing triangleCrossing(Ray ray, int object, vec3 a, vec3 b, vec3 c, vec3 normal)
{
    vec3 toA = a - ray.origin;
    vec3 toB = b - ray.origin;
    vec3 toC = c - ray.origin;
    float u = edgeSide(ray.direction, toB, toC);
    float v = edgeSide(ray.direction, toC, toA);
    float w = edgeSide(ray.direction, toA, toB);
    bool within = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    Crossing crossing = planeCrossing(ray, object, a, normal);
    crossing.found = crossing.found && within;
    return crossing;
}

// Shares of b and c at a point of the triangle's plane, given relative to a.
vec2 triangleShares(vec3 offset, vec3 edge_b, vec3 edge_c, vec3 normal)
{
    float area = dot(cross(edge_b, edge_c), normal);
    return vec2(dot(cross(offset, edge_c), normal), dot(cross(edge_b, offset), normal)) / area;
}
