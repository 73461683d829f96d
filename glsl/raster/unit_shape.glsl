// From unit shapes to the scene: all objects of a kind share a mesh, and the table says where each of them stands. Along the
// shape's own frame a unit shape is
//   sphere                x, y, z on the unit sphere, along along_u, axis, along_v
//   cylinder              x, z in the unit disk, y from 0 at the base to 1
//   disk                  x, y in the unit disk, along along_u, along_v
//   plane                 x, y in -1..1, times anchor.w metres: half the side of its patch, or 1 where it has no end
//   rectangle, triangle   x, y: shares of both edges, 0..1
// Places are homogeneous: those of w = 0 lie at infinity, in the direction xyz.

// The edges that a rectangle's dual basis belongs to.
vec3 dualEdge(vec3 own, vec3 other, vec3 normal)
{
    vec3 across = cross(other, normal);
    return across / dot(own, across);
}

vec4 placeInScene(vec4 local, int kind, Shape shape)
{
    vec3 along_u = shape.along_u.xyz;
    vec3 along_v = shape.along_v.xyz;
    vec3 axis = shape.axis.xyz;
    float size = shape.anchor.w;
    vec3 offset = vec3(0.0);
#ifdef HAS_SPHERE
    if (kind == KIND_SPHERE)
        offset = size * (local.x * along_u + local.y * axis + local.z * along_v);
#endif
#ifdef HAS_CYLINDER
    if (kind == KIND_OPEN_CYLINDER || kind == KIND_CAPPED_CYLINDER)
        offset = size * (local.x * along_u + local.z * along_v) + shape.axis.w * local.y * axis;
#endif
#ifdef HAS_FLAT
    if (kind == KIND_PLANE || kind == KIND_DISK)
        offset = size * (local.x * along_u + local.y * along_v);
    if (kind == KIND_RECTANGLE)
        offset = local.x * dualEdge(along_u, along_v, axis) + local.y * dualEdge(along_v, along_u, axis);
    if (kind == KIND_TRIANGLE)
        offset = local.x * (along_u - shape.anchor.xyz) + local.y * (along_v - shape.anchor.xyz);
#endif
    return vec4(local.w * shape.anchor.xyz + offset, local.w);
}

// On the outer or front side; of the length that it has on the unit shape.
vec3 normalInScene(vec3 local, int kind, Shape shape)
{
    vec3 framed = local.x * shape.along_u.xyz + local.y * shape.axis.xyz + local.z * shape.along_v.xyz;
    return kind >= KIND_PLANE ? shape.axis.xyz : framed;
}
