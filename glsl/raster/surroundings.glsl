// Mirrors and glass as rasterisers fake them: what they show is looked up in the sky, whatever stands between.

#include "trace/transmit.glsl"

#ifdef HAS_REFRACTION
// What is seen of the sky through a surface, by the direction that light is bent into where it comes in.
//
// By two interfaces: a round solid's far side stands to the light within as its near side does, so that its outward normal
// there is the near one mirrored; a flat shape's far side is parallel, and sends light on as it came, and so do caps. Both are right where the
// solid stands alone and is a sphere or a slab.
vec3 seenThrough(vec3 direction, vec3 normal, float c, int kind, Shape shape, Material material)
{
    bool entering = u_side > 0.0;
    float eta = entering ? material.bending.x : material.bending.y;
    float m = entering ? material.bending.z : material.bending.w;
    vec3 within = refractedDirection(direction, normal, c, eta, m);
#ifdef HAS_TWO_INTERFACES
    if (entering && kind != KIND_PLANE) {
        bool cap = kind == KIND_CAPPED_CYLINDER && abs(dot(normal, shape.axis.xyz)) > 0.7;
        if (kind >= KIND_PLANE || cap)
            return skyRadiance(direction);
        vec3 across = kind == KIND_SPHERE ? within : within - dot(within, shape.axis.xyz) * shape.axis.xyz;
        float chord = -2.0 * dot(normal, across) / max(dot(across, across), 1.0e-12);
        vec3 farNormal = normal + chord * across;
        float leaving = clamp(dot(within, farNormal), 0.0, 1.0);
        vec3 beyond = refractedDirection(within, -farNormal, leaving, material.bending.y, material.bending.w);
        vec3 sky = skyRadiance(beyond) * (1.0 - fresnelReflectance(leaving, material.bending.w));
#ifdef HAS_ABSORPTION
        sky *= exp(-material.absorption.xyz * shape.anchor.w * chord);
#endif
        return sky;
    }
#endif
    return skyRadiance(within);
}
#endif

#ifdef HAS_MIRROR_RAY
// What a surface shows of the sky, by the tracer's own surface equation.
vec3 surroundings(vec3 direction, vec3 normal, int kind, Shape shape, Material material)
{
    float c = clamp(-dot(direction, normal), 0.0, 1.0);
    vec3 reflection = material.mirror.xyz;
    vec3 through = vec3(0.0);
#ifdef HAS_REFRACTION
    float m = u_side > 0.0 ? material.bending.z : material.bending.w;
    float reflectance = fresnelReflectance(c, m);
    float passing = (1.0 - material.mirror.w) * transmitOf(material);
    reflection += passing * reflectance;
    if (passing * (1.0 - reflectance) > 0.0)
        through = passing * (1.0 - reflectance) * seenThrough(direction, normal, c, kind, shape, material);
#endif
    return reflection * skyRadiance(normalize(direction + 2.0 * c * normal)) + through;
}
#endif
