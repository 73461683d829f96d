// One ray: what it meets, what comes from there at once, and the rays that it splits into.
//   out = emission + (1 - mirror)(1 - transmit) local + mirror colour reflected
//       + (1 - mirror) transmit (R reflected + T refracted)

#include "trace/transmit.glsl"

struct Scatter {
    vec3 radiance; // weighted: adds straight to the pixel
#ifdef HAS_MIRROR_RAY
    Path reflected; // of weight 0 where there is none
#endif
#ifdef HAS_REFRACTION
    Path refracted;
#endif
};

#ifdef HAS_MIRROR_RAY
// The path that goes on from a surface, on its inner or outer side.
Path continued(Path path, Nearest hit, vec3 position, vec3 direction, vec3 weight, bool within)
{
    Path next = path;
    next.ray.origin = position;
    next.ray.direction = direction;
    next.ray.from = 2 * hit.object + (within ? 1 : 0);
    next.weight = weight;
#ifdef HAS_PICTURES
    next.travelled = path.travelled + hit.t;
#endif
#ifdef HAS_DEPTH_LIMIT
    // A path beyond the depth weighs nothing, so that it never takes the place of one within.
    next.bounces = path.bounces + 1;
    next.weight = next.bounces > u_depth ? vec3(0.0) : weight;
#ifdef HAS_LOST_WEIGHT
    next.beyond_depth = next.bounces > u_depth ? max(weight.x, max(weight.y, weight.z)) : 0.0;
#endif
#endif
    return next;
}
#endif

#ifdef HAS_LOCAL
// Radiance towards the viewer from all lights.
vec3 localRadiance(Surface surface, Material material, Ray ray, int object, bool inside)
{
    vec3 radiance = vec3(0.0);
#ifdef HAS_AMBIENT
    radiance += u_ambient * ambientColour(surface, material);
#endif
#ifdef HAS_LIGHTS
    radiance += lightsReflected(surface, material, ray, object, inside);
#endif
    return radiance;
}
#endif

// A sample's sum with what one more ray found: radiance (rgb), and one ray (a). Of trust the worst counts.
vec4 gathered(vec4 sum, Scatter found)
{
#ifdef HAS_TRUST
    return vec4(max(sum.x, found.radiance.x), max(sum.y, found.radiance.y), 0.0, sum.w + 1.0);
#else
    return sum + vec4(found.radiance, 1.0);
#endif
}

// Whatever a ray does not meet is computed all the same and not taken: see chosen().
Scatter scatter(Path path)
{
    Scatter result;
    Nearest hit = nearestHit(path.ray);
    bool missed = hit.object < 0;
    vec3 weight = path.weight;
#ifdef HAS_ABSORPTION
    // Beer-Lambert over the stretch that the ray has run through its medium.
    weight *= exp(-absorptionOf(path.medium) * hit.t);
#endif
    vec3 sky = skyRadiance(path.ray.direction);
#ifndef HAS_OBJECTS
    result.radiance = weight * sky;
#else
    hit.t = missed ? 0.0 : hit.t;
    hit.object = max(hit.object, 0);
    Material material = materialOf(hit.object);
    Surface surface = surfaceAt(path, hit, material);
    vec3 local = vec3(0.0);
#ifdef HAS_LOCAL
    local = localRadiance(surface, material, path.ray, hit.object, hit.inside);
#endif
#ifdef HAS_MIRROR_RAY
    local *= (1.0 - material.mirror.w) * (1.0 - transmitOf(material));
#endif
#ifdef HAS_EMISSION
    local = local + material.emission.xyz;
#endif
    result.radiance = weight * (missed ? sky : local);
#ifdef HAS_TRUST
    int kind = kindOf(hit.object);
    Shape shape = shapeOf(hit.object);
    float cosine = clamp(-dot(path.ray.direction, surface.normal), 0.0, 1.0);
    float curvature = hit.inside ? -curvatureOf(kind, shape, hit.cap) : curvatureOf(kind, shape, hit.cap);
    float across = blurAcross(path.blur, hit.t, crossingRounding(path.ray, hit, kind, shape, material));
    result.radiance = missed ? vec3(0.0) : trustAt(path, across, cosine, detailOf(kind, shape, material));
    // What is beyond trust stays so: its path is followed no further.
    weight *= 1.0 - result.radiance.x;
#endif
#ifdef HAS_MIRROR_RAY
    float c = clamp(-dot(path.ray.direction, surface.normal), 0.0, 1.0);
    vec3 reflection = material.mirror.xyz;
#ifdef HAS_REFRACTION
    float eta = hit.inside ? material.bending.y : material.bending.x;
    float m = hit.inside ? material.bending.w : material.bending.z;
    float reflectance = fresnelReflectance(c, m);
    float passing = (1.0 - material.mirror.w) * transmitOf(material);
    reflection += passing * reflectance;
    vec3 through = refractedDirection(path.ray.direction, surface.normal, c, eta, m);
    result.refracted =
        continued(path, hit, surface.position, through, missed ? vec3(0.0) : weight * (passing * (1.0 - reflectance)), !hit.inside);
#ifdef HAS_ABSORPTION
    result.refracted.medium = hit.inside ? int(material.absorption.w) : mediumOf(hit.object);
#endif
#ifdef HAS_TRUST
    result.refracted.blur =
        blurRefracted(path.blur, across, cosine, abs(dot(through, surface.normal)), eta, curvature);
#endif
#endif
    vec3 mirrored = normalize(path.ray.direction + 2.0 * c * surface.normal);
    result.reflected = continued(path, hit, surface.position, mirrored, missed ? vec3(0.0) : weight * reflection, hit.inside);
#ifdef HAS_TRUST
    result.reflected.blur = blurMirrored(path.blur, across, cosine, curvature);
#endif
#endif
#endif
#ifdef HAS_LOST_WEIGHT
    // In place of light: see lost_weight.glsl.
    result.radiance = vec3(0.0);
#ifdef HAS_MIRROR_RAY
    result.radiance += lostAtOnce(result.reflected);
#endif
#ifdef HAS_REFRACTION
    result.radiance += lostAtOnce(result.refracted);
#endif
#endif
    return result;
}
