// Flat shapes with compensated arithmetic: for planes that a ray nearly runs along, and for shapes that are small or thin against
// its way to them. `to_point` leads from the ray's origin to a point of the plane; `normal` may have any length.

// Where the line meets the plane, in lengths of the direction; `approach` is the direction's part along the normal, 0 for a
// line that runs along the plane.
struct PlaneRoot {
    float approach;
    float t;
};

PlaneRoot finePlaneRoot(FineVector to_point, FineVector direction, FineVector normal)
{
    vec2 height = fineDot(to_point, normal);
    vec2 slope = fineDot(direction, normal);
    PlaneRoot root;
    root.approach = slope.x + slope.y;
    root.t = (height.x + height.y) / (root.approach == 0.0 ? 1.0 : root.approach);
    return root;
}

// Whether the line's point at t is on the disk about that point.
bool fineWithinDisk(FineVector to_centre, FineVector direction, float t, float radius)
{
    vec3 offset = fineStep(fineVector(-to_centre.high, -to_centre.low), t, direction).high;
    return radius > 0.0 && radius < FAR_AWAY && dot(offset, offset) <= radius * radius;
}

// along_u and along_v map an offset from the corner to 0..1 along the edges.
bool fineWithinRectangle(FineVector to_corner, FineVector direction, float t, vec3 along_u, vec3 along_v)
{
    vec3 offset = fineStep(fineVector(-to_corner.high, -to_corner.low), t, direction).high;
    float u = dot(offset, along_u);
    float v = dot(offset, along_v);
    return u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
}

// The signed volume that the direction spans with an edge: the exact negative for the neighbour that runs the edge the other
// way, so that no ray passes between both.
float fineEdgeSide(FineVector direction, FineVector start, FineVector end)
{
    vec2 volume = fineDot(direction, fineCross(end, start));
    return volume.x + volume.y;
}

// Shares of a, b and c at the line's point, their sum not 1 but the volume that the direction spans with the triangle; all of
// one sign where the line meets it. Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2 (2013), without the
// shear, which compensation makes needless.
vec3 fineTriangleSides(FineVector direction, FineVector to_a, FineVector to_b, FineVector to_c)
{
    return vec3(fineEdgeSide(direction, to_b, to_c), fineEdgeSide(direction, to_c, to_a),
                fineEdgeSide(direction, to_a, to_b));
}

bool allOfOneSign(vec3 sides)
{
    return (sides.x >= 0.0 && sides.y >= 0.0 && sides.z >= 0.0) || (sides.x <= 0.0 && sides.y <= 0.0 && sides.z <= 0.0);
}
