// The scene as a loop per kind of shape over its table: the form for `trace.form = loop` and for the double-precision
// reference.

int firstOfKind(int kind)
{
    return int(u_kind_first[kind].x);
}

#ifdef HAS_CHOSEN_KERNELS
// Objects with kernels of their own stand behind all kinds, and their calls in the text.
bool standsApart(int object)
{
    return int(u_index[object].x) >= firstOfKind(KIND_COUNT);
}
#endif

// Where the ray meets one object, whatever its kind.
Crossing crossingOf(Ray ray, int object, int kind, Shape shape)
{
    vec3 anchor = shape.anchor.xyz;
    vec3 axis = shape.axis.xyz;
    Crossing crossing;
    crossing.found = false;
    crossing.t = FAR_AWAY;
    crossing.inside = false;
    crossing.cap = false;
#ifdef HAS_SPHERE
    if (kind == KIND_SPHERE)
        crossing = sphereCrossing(ray, object, anchor, shape.anchor.w);
#endif
#ifdef HAS_OPEN_CYLINDER
    if (kind == KIND_OPEN_CYLINDER)
        crossing = openCylinderCrossing(ray, object, anchor, axis, shape.anchor.w, shape.axis.w);
#endif
#ifdef HAS_CAPPED_CYLINDER
    if (kind == KIND_CAPPED_CYLINDER)
        crossing = cappedCylinderCrossing(ray, object, anchor, axis, shape.anchor.w, shape.axis.w);
#endif
#ifdef HAS_PLANE
    if (kind == KIND_PLANE)
        crossing = planeCrossing(ray, object, anchor, axis);
#endif
#ifdef HAS_DISK
    if (kind == KIND_DISK)
        crossing = diskCrossing(ray, object, anchor, axis, shape.anchor.w);
#endif
#ifdef HAS_RECTANGLE
    if (kind == KIND_RECTANGLE)
        crossing = rectangleCrossing(ray, object, anchor, axis, shape.along_u.xyz, shape.along_v.xyz);
#endif
#ifdef HAS_TRIANGLE
    if (kind == KIND_TRIANGLE)
        crossing = triangleCrossing(ray, object, anchor, shape.along_u.xyz, shape.along_v.xyz, axis);
#endif
    return crossing;
}

// The first object that the ray meets: one loop per kind, the kind a constant within each.
Nearest nearestHit(Ray ray)
{
    Nearest nearest = nothingYet();
    for (int kind = 0; kind < KIND_COUNT; ++kind) {
        for (int slot = firstOfKind(kind); slot < firstOfKind(kind + 1); ++slot) {
            int object = int(u_index[slot].w);
            nearest = nearerOfAnyOrder(nearest, crossingOf(ray, object, kind, u_shapes[slot]), object);
        }
    }
#ifdef HAS_CHOSEN_KERNELS
    nearest = nearestOfChosen(ray, nearest);
#endif
    return nearest;
}

#ifdef HAS_TINTED_SHADOWS
// What a transparent object lets through of the light from that distance.
vec3 tintOf(Ray ray, int object, int kind, Shape shape, float distance, Material material)
{
    Crossing crossing = crossingOf(ray, object, kind, shape);
    vec3 tint = wallTint(crossing, distance, material);
#ifdef HAS_SPHERE
    if (kind == KIND_SPHERE)
        tint = solidTint(sphereSpan(ray, shape.anchor.xyz, shape.anchor.w), ray, object, distance, material);
#endif
#ifdef HAS_CAPPED_CYLINDER
    if (kind == KIND_CAPPED_CYLINDER)
        tint = solidTint(
            cappedCylinderSpan(ray, shape.anchor.xyz, shape.axis.xyz, shape.anchor.w, shape.axis.w), ray,
            object, distance, material);
#endif
#ifdef HAS_PLANE
    if (kind == KIND_PLANE)
        tint = planeTint(crossing, ray, distance, shape.anchor.xyz, shape.axis.xyz, material);
#endif
    return tint;
}
#endif

// The share of the light from that distance along the ray that arrives; `glowing` does not shade its own light.
vec3 lightThrough(Ray ray, float distance, int glowing)
{
    vec3 through = vec3(1.0);
    for (int object = 0; object < SHAPE_COUNT; ++object) {
        int shadow = int(materialOf(object).shadow_tint.w);
        if (object == glowing || shadow == SHADOW_NONE)
            continue;
#ifdef HAS_CHOSEN_KERNELS
        if (standsApart(object))
            continue;
#endif
        int kind = kindOf(object);
        Shape shape = shapeOf(object);
#ifdef HAS_TINTED_SHADOWS
        if (shadow == SHADOW_TINTED)
            through *= tintOf(ray, object, kind, shape, distance, materialOf(object));
        else
            through *= unblocked(crossingOf(ray, object, kind, shape), distance);
#else
        through *= unblocked(crossingOf(ray, object, kind, shape), distance);
#endif
    }
#ifdef HAS_CHOSEN_KERNELS
    through *= lightThroughChosen(ray, distance, glowing);
#endif
    return through;
}
