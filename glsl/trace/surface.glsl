// What a ray finds where it meets an object: place, normal, coordinates and colour.

#include "trace/normal.glsl"

struct Surface {
    vec3 position; // scene frame, metres
    vec3 normal;   // unit, on the viewer's side
    vec3 colour;   // reflectance, with picture and pattern
};

#ifdef HAS_COORDINATES
// Coordinates on a surface: `metres` along it for patterns, `picture` in 0..1 with `extent` metres to that 1, and whether
// the picture wraps around (1) or ends (0) at its edges.
struct Coordinates {
    vec2 metres;
    vec2 picture;
    vec2 extent;
    vec2 wraps;
};

// The first where `first` holds, else the second.
Coordinates chosen(bool first, Coordinates a, Coordinates b)
{
    Coordinates result;
    result.metres = first ? a.metres : b.metres;
    result.picture = first ? a.picture : b.picture;
    result.extent = first ? a.extent : b.extent;
    result.wraps = first ? a.wraps : b.wraps;
    return result;
}

// A point of the texture frame's equator and height: longitude 0..1 as latLong() and the arc's length.
Coordinates sphereCoordinates(vec3 outward, Shape shape)
{
    vec3 local = vec3(dot(outward, shape.along_u.xyz), dot(outward, shape.axis.xyz), dot(outward, shape.along_v.xyz));
    Coordinates coordinates;
    coordinates.picture = latLong(local);
    coordinates.extent = shape.anchor.w * vec2(2.0 * PI, PI);
    coordinates.metres = (coordinates.picture - 0.5) * coordinates.extent;
    coordinates.wraps = vec2(1.0, 0.0);
    return coordinates;
}

// A disk's, or a cap's: the picture spans the square around it.
Coordinates diskCoordinates(vec3 offset, vec3 along_u, vec3 along_v, float radius)
{
    Coordinates coordinates;
    coordinates.metres = vec2(dot(offset, along_u), dot(offset, along_v));
    coordinates.extent = vec2(2.0 * radius);
    coordinates.picture = 0.5 + coordinates.metres / coordinates.extent;
    coordinates.wraps = vec2(0.0);
    return coordinates;
}

Coordinates cylinderCoordinates(vec3 offset, vec3 outward, Shape shape)
{
    // On a cap the normal runs along the axis.
    bool onCap = abs(dot(outward, shape.axis.xyz)) > 0.5;
    Coordinates side;
    float longitude = latLong(vec3(dot(outward, shape.along_u.xyz), 0.0, dot(outward, shape.along_v.xyz))).x;
    side.picture = vec2(longitude, dot(offset, shape.axis.xyz) / shape.axis.w);
    side.extent = vec2(2.0 * PI * shape.anchor.w, shape.axis.w);
    side.metres = (side.picture - vec2(0.5, 0.0)) * side.extent;
    side.wraps = vec2(1.0, 0.0);
    Coordinates cap = diskCoordinates(offset, shape.along_u.xyz, -shape.along_v.xyz, shape.anchor.w);
    return chosen(onCap, cap, side);
}

// Natural coordinates 0..1 along two edges of the given lengths, turned about the picture's middle.
Coordinates edgeCoordinates(vec2 shares, vec2 lengths, vec2 turn)
{
    vec2 centred = shares - 0.5;
    Coordinates coordinates;
    coordinates.picture =
        0.5 + vec2(turn.x * centred.x + turn.y * centred.y, turn.x * centred.y - turn.y * centred.x);
    coordinates.extent = lengths;
    vec2 along = shares * lengths;
    coordinates.metres = vec2(turn.x * along.x + turn.y * along.y, turn.x * along.y - turn.y * along.x);
    coordinates.wraps = vec2(0.0);
    return coordinates;
}

// An endless plane's: a picture repeats every `size` metres.
Coordinates planeCoordinates(vec3 offset, Shape shape, float size)
{
    Coordinates coordinates;
    coordinates.metres = vec2(dot(offset, shape.along_u.xyz), dot(offset, shape.along_v.xyz));
    coordinates.extent = vec2(size);
    coordinates.picture = coordinates.metres / size;
    coordinates.wraps = vec2(1.0);
    return coordinates;
}

// Only kinds of shapes that wear a picture or a pattern take part.
Coordinates coordinatesOf(vec3 position, vec3 outward, int kind, Shape shape, Material material)
{
    vec3 offset = position - shape.anchor.xyz;
    Coordinates coordinates;
    coordinates.metres = vec2(0.0);
    coordinates.picture = vec2(0.0);
    coordinates.extent = vec2(1.0);
    coordinates.wraps = vec2(0.0);
#ifdef HAS_PLANE_COORDINATES
    coordinates =
        chosen(kind == KIND_PLANE, planeCoordinates(offset, shape, material.checker_first.w), coordinates);
#endif
#ifdef HAS_SPHERE_COORDINATES
    coordinates = chosen(kind == KIND_SPHERE, sphereCoordinates(outward, shape), coordinates);
#endif
#ifdef HAS_CYLINDER_COORDINATES
    coordinates = chosen(kind == KIND_OPEN_CYLINDER || kind == KIND_CAPPED_CYLINDER,
                         cylinderCoordinates(offset, outward, shape), coordinates);
#endif
#ifdef HAS_DISK_COORDINATES
    coordinates = chosen(kind == KIND_DISK,
                         diskCoordinates(offset, shape.along_u.xyz, shape.along_v.xyz, shape.anchor.w), coordinates);
#endif
#ifdef HAS_RECTANGLE_COORDINATES
    vec2 shares = vec2(dot(offset, shape.along_u.xyz), dot(offset, shape.along_v.xyz));
    coordinates = chosen(kind == KIND_RECTANGLE,
                         edgeCoordinates(shares, vec2(shape.along_u.w, shape.along_v.w),
                                         vec2(shape.anchor.w, shape.axis.w)),
                         coordinates);
#endif
#ifdef HAS_TRIANGLE_COORDINATES
    vec2 corners = triangleShares(offset, shape.along_u.xyz - shape.anchor.xyz, shape.along_v.xyz - shape.anchor.xyz,
                                  shape.axis.xyz);
    coordinates = chosen(kind == KIND_TRIANGLE,
                         edgeCoordinates(corners, vec2(shape.along_u.w, shape.along_v.w),
                                         vec2(shape.anchor.w, shape.axis.w)),
                         coordinates);
#endif
    return coordinates;
}
#endif

#ifdef HAS_CHECKER
// 1 on the fields that take the second colour.
float checkerField(vec2 metres, float size)
{
    return mod(floor(metres.x / size) + floor(metres.y / size), 2.0);
}
#endif

#ifdef HAS_COORDINATES
// What a pattern and a picture make of a surface's colour; `away_m`: how far light has come from there to the eye, `slant`:
// the cosine between its way and the normal.
vec3 worn(vec3 position, vec3 outward, int kind, Shape shape, Material material, float away_m, float slant)
{
    Coordinates coordinates = coordinatesOf(position, outward, kind, shape, material);
    vec3 colour = vec3(1.0);
#ifdef HAS_CHECKER
    // An object without a pattern has fields of size 0, and its colour to itself.
    float size = material.checker.w;
    bool second = checkerField(coordinates.metres, size > 0.0 ? size : 1.0) > 0.5;
    vec3 field = second ? material.checker.xyz : material.checker_first.xyz;
    colour *= size > 0.0 ? field : vec3(1.0);
#endif
#ifdef HAS_PICTURES
    // The footprint of a sample at this distance, as a share of the picture: a circle of the ellipse's area.
    float footprint_m = u_camera.forward.w * away_m / sqrt(max(abs(slant), 0.001));
    colour *= pictureColour(int(material.colour.w), coordinates.picture, coordinates.wraps,
                            footprint_m / coordinates.extent);
#endif
    return colour;
}
#endif

// Everything about the point where a path meets an object.
Surface surfaceAt(Path path, Nearest hit, Material material)
{
    int kind = kindOf(hit.object);
    Shape shape = shapeOf(hit.object);
    vec3 outward = outwardNormal(path.ray, hit, kind, shape);
    Surface surface;
    surface.position = hitPosition(path.ray, hit, kind, shape, outward);
    surface.normal = hit.inside ? -outward : outward;
    surface.colour = material.colour.xyz;
#ifdef HAS_COORDINATES
    float away_m = 0.0;
#ifdef HAS_PICTURES
    away_m = path.travelled + hit.t;
#endif
    surface.colour *= worn(surface.position, outward, kind, shape, material, away_m, dot(path.ray.direction, outward));
#endif
    return surface;
}
