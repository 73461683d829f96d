// The nearest of several crossings, and what crossings do to light.

struct Nearest {
    float t;     // metres along the ray; FAR_AWAY where nothing is met
    int object;  // -1 where nothing is met
    bool inside; // as Crossing.inside
    bool cap;    // as Crossing.cap
};

Nearest nothingYet()
{
    Nearest nearest;
    nearest.t = FAR_AWAY;
    nearest.object = -1;
    nearest.inside = false;
    nearest.cap = false;
    return nearest;
}

// The crossing in place of what was nearest so far.
Nearest replacedIf(bool better, Nearest nearest, Crossing crossing, int object)
{
    Nearest result;
    result.t = better ? crossing.t : nearest.t;
    result.object = better ? object : nearest.object;
    result.inside = better ? crossing.inside : nearest.inside;
    result.cap = better ? crossing.cap : nearest.cap;
    return result;
}

// The nearer of both; at equal distance the one that was there first, so objects are asked in order of their ids.
Nearest nearer(Nearest nearest, Crossing crossing, int object)
{
    return replacedIf(crossing.found && crossing.t < nearest.t, nearest, crossing, object);
}

// As nearer(), for objects that are not asked in order of their ids.
Nearest nearerOfAnyOrder(Nearest nearest, Crossing crossing, int object)
{
    bool better = crossing.found && (crossing.t < nearest.t || (crossing.t == nearest.t && object < nearest.object));
    return replacedIf(better, nearest, crossing, object);
}

// 0 where the crossing stands between a surface and a light at that distance, else 1.
float unblocked(Crossing crossing, float distance)
{
    return crossing.found && crossing.t < distance ? 0.0 : 1.0;
}

// What a transparent wall without thickness lets through.
vec3 wallTint(Crossing crossing, float distance, Material material)
{
    return crossing.found && crossing.t < distance ? material.shadow_tint.xyz : vec3(1.0);
}

#ifdef HAS_SHADOW_ABSORPTION
// Beer-Lambert over a chord, relative to the medium around, whose own chord holds this one: above 1 for a clear bubble in
// dark glass. The exponent is held where the product of two such bubbles is finite too: infinite times the 0 of the glass
// would be no number.
vec3 chordTransmittance(Material material, float chord)
{
    return exp(min(-material.shadow_absorption.xyz * chord, vec3(40.0)));
}
#endif

// What a transparent solid lets through: its tint, and Beer-Lambert over the chord, clipped to the light. Absorption is
// taken relative to the medium outside, so that nested media add up right.
vec3 solidTint(Span span, Ray ray, int object, float distance, Material material)
{
    bool startsWithin = ray.from == 2 * object + 1;
    float enter = startsWithin ? 0.0 : max(span.near, 0.0);
    float leave = min(span.far, distance);
    vec3 tint = material.shadow_tint.xyz;
    // A black one is opaque: from within, its surface alone stands in the way.
    bool meets = tint != vec3(0.0) || enter > 0.0 || span.far < distance;
    bool passes = (startsWithin || span.found) && leave > enter && ray.from != 2 * object && meets;
#ifdef HAS_SHADOW_ABSORPTION
    tint *= chordTransmittance(material, max(leave - enter, 0.0));
#endif
    return passes ? tint : vec3(1.0);
}

// What an endless plane lets through: the medium behind it fills a half-space. `middle_height` is that of planeMiddle() above
// the plane.
vec3 halfSpaceTint(Crossing crossing, float distance, float middle_height, Material material)
{
    bool crosses = crossing.found && crossing.t < distance;
    vec3 tint = crosses ? material.shadow_tint.xyz : vec3(1.0);
#ifdef HAS_SHADOW_ABSORPTION
    float end = crosses ? crossing.t : distance;
    float behind = middle_height < 0.0 ? end : (crosses ? distance - crossing.t : 0.0);
    tint *= chordTransmittance(material, behind);
#endif
    return tint;
}

// The middle of the way that runs on one side of the plane, from the ray's origin on.
vec3 planeMiddle(Crossing crossing, Ray ray, float distance)
{
    bool crosses = crossing.found && crossing.t < distance;
    return ray.origin + 0.5 * (crosses ? crossing.t : distance) * ray.direction;
}

vec3 planeTint(Crossing crossing, Ray ray, float distance, vec3 point, vec3 normal, Material material)
{
    float height = dot(planeMiddle(crossing, ray, distance) - point, normal);
    return halfSpaceTint(crossing, distance, height, material);
}

#ifdef HAS_CHOSEN_KERNELS
vec3 finePlaneTint(Crossing crossing, Ray ray, float distance, FineVector point, FineVector normal, Material material)
{
    float height = fineHeight(planeMiddle(crossing, ray, distance), point, normal);
    return halfSpaceTint(crossing, distance, height, material);
}
#endif
