// Shadows from maps of how far each light gets.

// A place on a view's map, -1..1 both ways, and its distance ahead.
vec3 onShadowMap(ShadowView view, vec3 offset)
{
    float ahead = dot(offset, view.forward.xyz);
    float spread = view.eye.w > 0.5 ? ahead : 1.0;
    return vec3(vec2(dot(offset, view.right.xyz), dot(offset, view.up.xyz)) / spread, ahead);
}

// What the map of a view holds: metres from the light, or along its parallel rays.
float lightDepth(ShadowView view, vec3 offset)
{
    return view.eye.w > 0.5 ? length(offset) : dot(offset, view.forward.xyz);
}

// Which of the six views of a light that shines all around: +x, -x, +y, -y, +z, -z.
int cubeFace(vec3 offset)
{
    vec3 size = abs(offset);
    if (size.x >= size.y && size.x >= size.z)
        return offset.x > 0.0 ? 0 : 1;
    if (size.y >= size.z)
        return offset.y > 0.0 ? 2 : 3;
    return offset.z > 0.0 ? 4 : 5;
}

// 1 where the light reaches as deep as that, else 0.
float reaches(int layer, ivec2 texel, float depth)
{
    ivec2 last = textureSize(u_shadow_maps, 0).xy - 1;
    return depth <= texelFetch(u_shadow_maps, ivec3(clamp(texel, ivec2(0), last), layer), 0).x ? 1.0 : 0.0;
}

#ifdef HAS_SHADING_PLANES
// 0 where an endless plane, which no map can hold, parts a place from a light, else 1. `light`: its place, or of w = 0 the
// direction to it. A plane does not shade itself.
float passesPlanes(vec3 position, vec4 light)
{
    float passes = 1.0;
    for (int i = 0; i < SHADING_PLANE_COUNT; ++i) {
        vec4 plane = u_shading_planes[i];
        float here = dot(plane.xyz, position) - plane.w;
        float there = dot(plane.xyz, light.xyz) - plane.w * light.w;
        passes = here * there < 0.0 && i != drawnPlane() ? 0.0 : passes;
    }
    return passes;
}
#endif

// The share of a light that reaches a place, by the map of its view. A texel stands for all that it covers, over which a
// surface that leans away from the light by an angle a gets deeper by its width times tan a: so much is forgiven, times
// u_shadow_bias, and what rounding takes from the depth. `normal` is that of the surface as it is tessellated.
float seesLight(int layer, vec3 position, vec3 normal, vec3 towards)
{
    ShadowView view = u_shadow_views[layer];
    vec3 offset = position - view.eye.xyz;
    vec3 place = onShadowMap(view, offset);
    float side_px = float(textureSize(u_shadow_maps, 0).x);
    float across = 2.0 / min(length(view.right.xyz), length(view.up.xyz)); // a map may be wider than high
    float texel_m = across * (view.eye.w > 0.5 ? place.z : 1.0) / side_px;
    float cosine = clamp(abs(dot(normal, towards)), 0.01, 1.0);
    float lean = sqrt(1.0 - cosine * cosine) / cosine;
#ifdef HAS_SHADOW_FILTER
    float reach_px = 2.2; // from a texel's edge to the middle of the farthest of nine
#else
    float reach_px = 0.8; // half a texel's diagonal, and some
#endif
    float depth = lightDepth(view, offset);
    depth -= u_shadow_bias * reach_px * texel_m * lean + 8.0 * SINGLE_ROUNDOFF * (abs(depth) + length(position));
    ivec2 texel = ivec2(floor((0.5 + 0.5 * place.xy) * side_px));
#ifdef HAS_SHADOW_FILTER
    float lit = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            lit += reaches(layer, texel + ivec2(x, y), depth) / 9.0;
#else
    float lit = reaches(layer, texel, depth);
#endif
    bool beyond = max(abs(place.x), abs(place.y)) > 1.0 || (view.eye.w > 0.5 && place.z <= 0.0);
    return beyond ? 1.0 : lit;
}

// The same of a light with six views.
float seesLightAllAround(int first, vec3 position, vec3 normal, vec3 towards)
{
    return seesLight(first + cubeFace(position - u_shadow_views[first].eye.xyz), position, normal, towards);
}
