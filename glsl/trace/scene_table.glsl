// The scene's table: what each object is. Shapes stand sorted by kind: u_kind_first[k].x up to u_kind_first[k + 1].x are those
// of kind k, in the order of the file. u_index[i]: x: the slot of object i in u_shapes; y: its kind; z: its material; w: the
// object in slot i.

Shape shapeOf(int object)
{
    return u_shapes[int(u_index[object].x)];
}

int kindOf(int object)
{
    return int(u_index[object].y);
}

int mediumOf(int object)
{
    return int(u_index[object].z);
}

Material materialOf(int object)
{
    return u_materials[mediumOf(object)];
}

#ifdef HAS_ABSORPTION
// Per metre of the medium with that index; -1 is air.
vec3 absorptionOf(int medium)
{
    vec3 absorption = vec3(0.0);
    if (medium >= 0)
        absorption = u_materials[medium].absorption.xyz;
    return absorption;
}
#endif
