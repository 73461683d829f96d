// The place and the normal of a hit.

// The unit normal on the outer (front) side. Round shapes take it from the place relative to their anchor, less its part
// along the axis on a cylinder's side; never from the difference of two places of the scene.
vec3 outwardNormal(Ray ray, Nearest hit, int kind, Shape shape)
{
    vec3 normal = shape.axis.xyz;
#ifdef HAS_ROUND_SHAPE
    vec3 place = (ray.origin - shape.anchor.xyz) + hit.t * ray.direction;
    bool round = false;
#ifdef HAS_SPHERE
    round = kind == KIND_SPHERE;
#endif
#ifdef HAS_CYLINDER
    bool side = (kind == KIND_OPEN_CYLINDER || kind == KIND_CAPPED_CYLINDER) && !hit.cap;
    place = side ? place - dot(place, normal) * normal : place;
    round = round || side;
#endif
    vec3 radial = normalize(place);
#ifdef HAS_CAPPED_CYLINDER
    // A ray that runs up the axis leaves through the top and enters through the base.
    bool base = hit.cap && (dot(ray.direction, normal) > 0.0) != hit.inside;
    normal = base ? -normal : normal;
#endif
    normal = round ? radial : normal;
#endif
#ifdef HAS_CHOSEN_KERNELS
    normal = chosenNormal(ray.origin + hit.t * ray.direction, hit, normal);
#endif
    return normal;
}

// The point that was met. On a sphere it is the centre plus the radius along the normal, on a flat shape it is brought back
// into the plane: no error of t enters, however far the ray has come.
vec3 hitPosition(Ray ray, Nearest hit, int kind, Shape shape, vec3 outward)
{
    vec3 position = ray.origin + hit.t * ray.direction;
#ifdef HAS_FLAT
    vec3 inPlane = position - dot(position - shape.anchor.xyz, outward) * outward;
    position = kind >= KIND_PLANE ? inPlane : position;
#endif
#ifdef HAS_SPHERE
    position = kind == KIND_SPHERE ? shape.anchor.xyz + shape.anchor.w * outward : position;
#endif
#ifdef HAS_CHOSEN_KERNELS
    position = chosenPosition(ray.origin + hit.t * ray.direction, hit.object, outward, position);
#endif
    return position;
}
