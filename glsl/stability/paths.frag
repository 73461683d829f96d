// Follows one path through glass or among mirrors for every row of a table, by the product's kernels, normals and places of
// hits. One of HAS_BALL, HAS_SLAB, HAS_FACING, HAS_GALLERY and HAS_ORBIT chooses the scene; HAS_TEXTBOOK takes the books'
// formulas in their place.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/sphere.glsl"
#include "kernel/flat.glsl"
#include "kernel/dielectric.glsl"
#include "trace/nearest.glsl"
#include "trace/normal.glsl"
#include "stability/textbook.glsl"

uniform sampler2D u_rows; // the texels of a row lie u_height apart, one above the other
uniform int u_height;
uniform int u_part;
out vec4 o_answer;

vec4 texel(int which)
{
    return texelFetch(u_rows, ivec2(gl_FragCoord.xy) + ivec2(0, which * u_height), 0);
}

// A hit as scattering needs it.
struct Stop {
    Nearest hit; // object -1: the ray escapes
    vec3 position;
    vec3 normal; // unit, facing the ray
};

#ifdef HAS_TEXTBOOK
// Leaves a surface by a fixed distance; the normal is that of the place, which the ray's equation gives.
Stop sphereStop(Ray ray, int object, vec4 sphere)
{
    Span span = textbookSphere(ray.origin, ray.direction, sphere.xyz, sphere.w);
    Stop stop;
    stop.hit = nothingYet();
    stop.hit.inside = span.near <= 1.0e-4;
    stop.hit.t = stop.hit.inside ? span.far : span.near;
    stop.hit.object = span.found && stop.hit.t > 1.0e-4 ? object : -1;
    stop.position = ray.origin + stop.hit.t * ray.direction;
    vec3 outward = (stop.position - sphere.xyz) / sphere.w;
    stop.normal = stop.hit.inside ? -outward : outward;
    return stop;
}

Stop planeStop(Ray ray, int object, vec3 point, vec3 normal)
{
    Stop stop;
    stop.hit = nothingYet();
    stop.hit.t = textbookPlane(ray.origin, ray.direction, point, normal);
    stop.hit.object = stop.hit.t > 1.0e-4 ? object : -1;
    stop.hit.inside = dot(ray.direction, normal) > 0.0;
    stop.position = ray.origin + stop.hit.t * ray.direction;
    stop.normal = stop.hit.inside ? -normal : normal;
    return stop;
}

vec3 mirrored(vec3 direction, vec3 normal)
{
    return direction - 2.0 * dot(direction, normal) * normal;
}

// bending: as in Material.
vec3 bent(vec3 direction, Stop stop, vec4 bending)
{
    return refract(direction, stop.normal, stop.hit.inside ? bending.y : bending.x);
}
#else
Stop stopOf(Ray ray, Nearest hit, int kind, Shape shape)
{
    Stop stop;
    stop.hit = hit;
    vec3 outward = outwardNormal(ray, hit, kind, shape);
    stop.position = hitPosition(ray, hit, kind, shape, outward);
    stop.normal = hit.inside ? -outward : outward;
    return stop;
}

Stop sphereStop(Ray ray, int object, vec4 sphere)
{
    Shape shape;
    shape.anchor = sphere;
    shape.axis = vec4(0.0, 1.0, 0.0, 0.0);
    Nearest hit = nearer(nothingYet(), sphereCrossing(ray, object, sphere.xyz, sphere.w), object);
    return stopOf(ray, hit, KIND_SPHERE, shape);
}

Stop planeStop(Ray ray, int object, vec3 point, vec3 normal)
{
    Shape shape;
    shape.anchor = vec4(point, 0.0);
    shape.axis = vec4(normal, 0.0);
    Nearest hit = nearer(nothingYet(), planeCrossing(ray, object, point, normal), object);
    return stopOf(ray, hit, KIND_PLANE, shape);
}

// Both as trace/scatter.glsl has them.
vec3 mirrored(vec3 direction, vec3 normal)
{
    float c = clamp(-dot(direction, normal), 0.0, 1.0);
    return normalize(direction + 2.0 * c * normal);
}

vec3 bent(vec3 direction, Stop stop, vec4 bending)
{
    float c = clamp(-dot(direction, stop.normal), 0.0, 1.0);
    return refractedDirection(direction, stop.normal, c, stop.hit.inside ? bending.y : bending.x,
                              stop.hit.inside ? bending.w : bending.z);
}
#endif

Ray rayOfRow()
{
    Ray ray;
    ray.origin = texel(0).xyz;
    ray.direction = texel(1).xyz;
    ray.from = -1;
    return ray;
}

// The ray that goes on from a stop: on the side that it came from, or through the surface.
Ray onwards(Stop stop, vec3 direction, bool through)
{
    Ray ray;
    ray.origin = stop.position;
    ray.direction = direction;
    ray.from = 2 * stop.hit.object + (stop.hit.inside != through ? 1 : 0);
    return ray;
}

#ifdef HAS_BALL
// 2: centre, radius; 3: bending. xyz: direction behind the ball, w: 1 where both of its sides were met.
vec4 answerOfRow()
{
    Ray ray = rayOfRow();
    Stop first = sphereStop(ray, 0, texel(2));
    ray = onwards(first, bent(ray.direction, first, texel(3)), true);
    Stop second = sphereStop(ray, 0, texel(2));
    bool met = first.hit.object == 0 && second.hit.object == 0 && second.hit.inside;
    return vec4(bent(ray.direction, second, texel(3)), met ? 1.0 : 0.0);
}
#endif

#ifdef HAS_SLAB
// 2 and 3: a point of the front and of the back, 4: normal, towards the eye; 5: bending. Part 0: where the path leaves the
// slab, w: 1 where both planes were met; part 1: where it enters it.
vec4 answerOfRow()
{
    Ray ray = rayOfRow();
    vec4 bending = texel(5);
    Stop first = planeStop(ray, 0, texel(2).xyz, texel(4).xyz);
    ray = onwards(first, bent(ray.direction, first, bending), true);
    Stop second = planeStop(ray, 1, texel(3).xyz, texel(4).xyz);
    bool met = first.hit.object == 0 && second.hit.object == 1;
    return vec4(u_part == 0 ? second.position : first.position, met ? 1.0 : 0.0);
}
#endif

#ifdef HAS_FACING
// 0.w: bounces; 2 and 3: a point of each mirror, 4: their normal. xyz: the last bounce's place, w: 1 where none was missed.
vec4 answerOfRow()
{
    Ray ray = rayOfRow();
    int bounces = int(texel(0).w);
    vec3 normal = texel(4).xyz;
    int next = dot(ray.direction, normal) > 0.0 ? 1 : 0;
    bool met = true;
    for (int i = 0; i < bounces; ++i) {
        Stop stop = planeStop(ray, next, texel(2 + next).xyz, normal);
        met = met && stop.hit.object == next;
        ray = onwards(stop, mirrored(ray.direction, stop.normal), false);
        next = 1 - next;
    }
    return vec4(ray.origin, met ? 1.0 : 0.0);
}
#endif

#ifdef HAS_GALLERY
// 0.w: bounces; 2: centre, radius of the sphere on whose inner side the ray starts. xyz: the last bounce's place, w: 1 where
// none was missed.
vec4 answerOfRow()
{
    Ray ray = rayOfRow();
    ray.from = 1;
    int bounces = int(texel(0).w);
    vec4 sphere = texel(2);
    bool met = true;
    for (int i = 0; i < bounces; ++i) {
        Stop stop = sphereStop(ray, 0, sphere);
        met = met && stop.hit.object == 0 && stop.hit.inside;
        ray = onwards(stop, mirrored(ray.direction, stop.normal), false);
    }
    return vec4(ray.origin, met ? 1.0 : 0.0);
}
#endif

#ifdef HAS_ORBIT
// 0.w: bounces, at most 12; 1.w: bounces to the earlier place; 2 to 5: spheres, of radius 0 where there are fewer. Part 0: the
// last place, w: the spheres met, digits to base 4, -1 where one was missed; part 1: the earlier place.
vec4 answerOfRow()
{
    Ray ray = rayOfRow();
    int bounces = int(texel(0).w);
    int early = int(texel(1).w);
    float itinerary = 0.0;
    vec3 earlier = vec3(0.0);
    bool met = true;
    for (int i = 0; i < bounces; ++i) {
        Stop nearest;
        nearest.hit = nothingYet();
        nearest.position = ray.origin;
        nearest.normal = ray.direction;
        for (int k = 0; k < 4; ++k) {
            vec4 sphere = texel(2 + k);
            Stop stop = sphereStop(ray, k, sphere);
            // The mirrors are met from outside alone.
            bool better = sphere.w > 0.0 && stop.hit.object == k && !stop.hit.inside && stop.hit.t < nearest.hit.t;
            if (better)
                nearest = stop;
        }
        met = met && nearest.hit.object >= 0;
        itinerary = 4.0 * itinerary + float(max(nearest.hit.object, 0));
        ray = onwards(nearest, mirrored(ray.direction, nearest.normal), false);
        if (i + 1 == early)
            earlier = ray.origin;
    }
    return u_part == 0 ? vec4(ray.origin, met ? itinerary : -1.0) : vec4(earlier, 0.0);
}
#endif

void main()
{
    o_answer = answerOfRow();
}
