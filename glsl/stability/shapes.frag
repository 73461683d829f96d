// Runs one kernel over a table of rays and shapes, one to a pixel. HAS_TEXTBOOK, HAS_ROBUST, HAS_COMPENSATED or HAS_CURVATURE
// chooses the kernel, HAS_SPHERE to HAS_TRIANGLE the kind of shape.

#ifdef HAS_PRECISE
#extension GL_ARB_gpu_shader5 : require
#endif

#include "shared/constants.glsl"
#include "kernel/ray.glsl"
#include "kernel/exact.glsl"
#include "kernel/fine.glsl"
#include "kernel/sphere.glsl"
#include "kernel/cylinder.glsl"
#include "kernel/flat.glsl"
#include "kernel/fine_round.glsl"
#include "kernel/fine_flat.glsl"
#include "kernel/curved.glsl"
#include "stability/textbook.glsl"

uniform sampler2D u_rows; // the texels of a row lie u_height apart, one above the other
uniform int u_height;
uniform int u_part; // 0: hit (1 or 0), t; 1: the normal
out vec4 o_answer;

// The rows' texels.
const int ORIGIN = 0;         // w: least t
const int DIRECTION = 1;      // w: 1 where the origin lies on the surface
const int DIRECTION_LOW = 2;  // what rounding to DIRECTION lost
const int ANCHOR = 3;         // centre, base, point, corner or a; w: radius, or 1 / radius
const int ANCHOR_LOW = 4;     // w: how far the surface point lies above the base
const int AXIS = 5;           // axis or normal; w: height
const int AXIS_LOW = 6;
const int ALONG_U = 7;        // as in Shape, or b
const int ALONG_V = 8;        // or c
const int ALONG_U_LOW = 9;    // of b
const int ALONG_V_LOW = 10;   // of c
const int SURFACE_NORMAL = 11; // of the surface point that stands as ANCHOR
const int SURFACE_NORMAL_LOW = 12;

vec4 texel(int which)
{
    return texelFetch(u_rows, ivec2(gl_FragCoord.xy) + ivec2(0, which * u_height), 0);
}

struct Answer {
    bool hit;
    float t;
    vec3 normal;
};

Answer miss()
{
    Answer answer;
    answer.hit = false;
    answer.t = 0.0;
    answer.normal = vec3(0.0);
    return answer;
}

// Which of two crossings of a line counts; 2 where none does.
int rootThatCounts(bool nearThere, float near, bool farThere, float far)
{
    float least = texel(ORIGIN).w;
    bool onSurface = texel(DIRECTION).w > 0.5;
#ifdef HAS_TEXTBOOK
    // Books leave a surface by a fixed distance.
    least = onSurface ? 1.0e-4 : least;
    onSurface = false;
#endif
    bool nearIsOrigin = onSurface && abs(near) <= abs(far);
    bool farIsOrigin = onSurface && !nearIsOrigin;
    if (nearThere && near > least && !nearIsOrigin)
        return 0;
    return farThere && far > least && !farIsOrigin ? 1 : 2;
}

Ray rayOfRow()
{
    Ray ray;
    ray.origin = texel(ORIGIN).xyz;
    ray.direction = texel(DIRECTION).xyz;
    ray.from = -1;
    return ray;
}

FineVector fineTexel(int high, int low)
{
    return fineVector(texel(high).xyz, texel(low).xyz);
}

// The vector from a point of the row to the ray's origin, and the way back.
FineVector fromPoint(int high, int low)
{
    return fineDifference(texel(ORIGIN).xyz, texel(high).xyz, texel(low).xyz);
}

FineVector toPoint(int high, int low)
{
    FineVector f = fromPoint(high, low);
    return fineVector(-f.high, -f.low);
}

#ifdef HAS_SPHERE
Answer answerOfRow()
{
    Ray ray = rayOfRow();
    vec3 anchor = texel(ANCHOR).xyz;
    float radius = texel(ANCHOR).w;
#ifdef HAS_TEXTBOOK
    Span span = textbookSphere(ray.origin, ray.direction, anchor, radius);
#endif
#ifdef HAS_ROBUST
    Span span = sphereSpan(ray, anchor, radius);
#endif
#ifdef HAS_COMPENSATED
    Chord chord = fineSphereChord(fromPoint(ANCHOR, ANCHOR_LOW), fineTexel(DIRECTION, DIRECTION_LOW), radius);
    Span span = chord.span;
#endif
#ifdef HAS_CURVATURE
    FineVector normal = fineTexel(SURFACE_NORMAL, SURFACE_NORMAL_LOW);
    Span span = curvedSphereSpan(ray, anchor, normal, radius);
#endif
    int root = rootThatCounts(span.found, span.near, span.found, span.far);
    if (root == 2)
        return miss();
    Answer answer;
    answer.hit = true;
    answer.t = root == 0 ? span.near : span.far;
#ifdef HAS_TEXTBOOK
    answer.normal = normalize(ray.origin + answer.t * ray.direction - anchor);
#endif
#ifdef HAS_ROBUST
    answer.normal = normalize((ray.origin - anchor) + answer.t * ray.direction);
#endif
#ifdef HAS_COMPENSATED
    answer.normal = chordNormal(chord, root == 1, radius);
#endif
#ifdef HAS_CURVATURE
    answer.normal = curvedNormal(ray.origin - anchor + answer.t * ray.direction, normal.high, radius);
#endif
    return answer;
}
#endif

#ifdef HAS_CYLINDER
Answer answerOfRow()
{
    Ray ray = rayOfRow();
    vec3 base = texel(ANCHOR).xyz;
    float radius = texel(ANCHOR).w;
    vec3 axis = texel(AXIS).xyz;
    float height = texel(AXIS).w;
    vec3 offset = ray.origin - base;
    float z = dot(offset, axis);
    float dz = dot(ray.direction, axis);
#ifdef HAS_TEXTBOOK
    Span side = textbookSide(ray.origin, ray.direction, base, axis, radius);
#endif
#ifdef HAS_ROBUST
    Span side = sideSpan(ray, base, axis, radius);
#endif
#ifdef HAS_COMPENSATED
    FineVector f = fromPoint(ANCHOR, ANCHOR_LOW);
    FineVector direction = fineTexel(DIRECTION, DIRECTION_LOW);
    FineVector fineAxis = fineTexel(AXIS, AXIS_LOW);
    Chord chord = fineSideChord(f, direction, fineAxis, radius);
    Span side = chord.span;
    Span slab = fineSlabSpan(f, direction, fineAxis);
#else
#ifdef HAS_CURVATURE
    FineVector normal = fineTexel(SURFACE_NORMAL, SURFACE_NORMAL_LOW);
    Span side = curvedSideSpan(ray, base, normal, radius, axis);
    float aboveBase = texel(ANCHOR_LOW).w;
    Span slab = slabSpan(ray, base - aboveBase * axis, axis, height);
#else
    Span slab = slabSpan(ray, base, axis, height);
#endif
#endif
#ifdef HAS_CAPPED_CYLINDER
    Span span = commonSpan(side, slab);
    int root = rootThatCounts(span.found, span.near, span.found, span.far);
    bool cap = root == 0 ? slab.near > side.near : slab.far < side.far;
#else
    // Within the wall where the slab is met between both of its planes.
    Span span = side;
    bool nearThere = side.found && slab.found && side.near >= slab.near && side.near <= slab.far;
    bool farThere = side.found && slab.found && side.far >= slab.near && side.far <= slab.far;
    int root = rootThatCounts(nearThere, side.near, farThere, side.far);
    bool cap = false;
#endif
    if (root == 2)
        return miss();
    Answer answer;
    answer.hit = true;
    answer.t = root == 0 ? span.near : span.far;
    if (cap) {
        answer.normal = (dz > 0.0) == (root == 1) ? axis : -axis;
        return answer;
    }
    vec3 place = offset + answer.t * ray.direction;
#ifdef HAS_COMPENSATED
    answer.normal = chordNormal(chord, root == 1, radius);
#else
#ifdef HAS_CURVATURE
    answer.normal = curvedNormal(place - dot(place, axis) * axis, normal.high, radius);
#else
    answer.normal = normalize(place - dot(place, axis) * axis);
#endif
#endif
    return answer;
}
#endif

#ifdef HAS_FLAT
Answer answerOfRow()
{
    Ray ray = rayOfRow();
    vec3 anchor = texel(ANCHOR).xyz;
    vec3 normal = texel(AXIS).xyz;
    vec3 along_u = texel(ALONG_U).xyz;
    vec3 along_v = texel(ALONG_V).xyz;
    float radius = texel(ANCHOR).w;
    Answer answer;
    answer.normal = normal;
#ifdef HAS_COMPENSATED
    FineVector direction = fineTexel(DIRECTION, DIRECTION_LOW);
    FineVector point = toPoint(ANCHOR, ANCHOR_LOW);
    PlaneRoot plane = finePlaneRoot(point, direction, fineTexel(AXIS, AXIS_LOW));
    answer.hit = plane.approach != 0.0;
    answer.t = plane.t;
#ifdef HAS_DISK
    answer.hit = answer.hit && fineWithinDisk(point, direction, plane.t, radius);
#endif
#ifdef HAS_RECTANGLE
    answer.hit = answer.hit && fineWithinRectangle(point, direction, plane.t, along_u, along_v);
#endif
#ifdef HAS_TRIANGLE
    vec3 sides = fineTriangleSides(direction, point, toPoint(ALONG_U, ALONG_U_LOW), toPoint(ALONG_V, ALONG_V_LOW));
    answer.hit = answer.hit && allOfOneSign(sides);
#endif
#endif
#ifdef HAS_ROBUST
#ifdef HAS_PLANE
    Crossing crossing = planeCrossing(ray, 0, anchor, normal);
#endif
#ifdef HAS_DISK
    Crossing crossing = diskCrossing(ray, 0, anchor, normal, radius);
#endif
#ifdef HAS_RECTANGLE
    Crossing crossing = rectangleCrossing(ray, 0, anchor, normal, along_u, along_v);
#endif
#ifdef HAS_TRIANGLE
    Crossing crossing = triangleCrossing(ray, 0, anchor, along_u, along_v, normal);
#endif
    answer.hit = crossing.found;
    answer.t = crossing.t;
#endif
#ifdef HAS_TEXTBOOK
#ifdef HAS_TRIANGLE
    vec4 met = textbookTriangle(ray.origin, ray.direction, anchor, along_u, along_v);
    answer.t = met.x;
    answer.hit = met.w > 0.5 && met.y >= 0.0 && met.z >= 0.0 && met.y + met.z <= 1.0;
#else
    answer.t = textbookPlane(ray.origin, ray.direction, anchor, normal);
    answer.hit = true;
    vec3 offset = ray.origin + answer.t * ray.direction - anchor;
#ifdef HAS_DISK
    answer.hit = dot(offset, offset) <= radius * radius;
#endif
#ifdef HAS_RECTANGLE
    float u = dot(offset, along_u);
    float v = dot(offset, along_v);
    answer.hit = u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
#endif
#endif
#endif
    answer.hit = answer.hit && texel(DIRECTION).w < 0.5 && answer.t > texel(ORIGIN).w;
    return answer;
}
#endif

void main()
{
    Answer answer = answerOfRow();
    // What degenerate input makes of t is no place.
    if (!(answer.hit && answer.t < FAR_AWAY))
        answer = miss();
    o_answer = u_part == 0 ? vec4(answer.hit ? 1.0 : 0.0, answer.t, 0.0, 0.0) : vec4(answer.normal, 0.0);
}
