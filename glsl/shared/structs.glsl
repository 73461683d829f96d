// What the host fills in: vec4 only, so that std140 and C++ lay it out alike. Lengths in metres, in the scene frame
// (the world less the scene origin), colours linear.

// An object's geometry.
//               anchor.xyz    anchor.w        axis.xyz      axis.w          along_u, along_v
// sphere        centre        radius          +y            -               texture frame, unit
// cylinder      base's centre radius          unit axis     height          texture frame, unit
// plane         point         -               unit normal   -               unit, along the surface
// disk          centre        radius          unit normal   -               unit, along the surface
// rectangle     corner        cos of texture  unit normal   sin of texture  offset from the corner to 0..1 along an edge;
//                             rotation                      rotation        w: that edge's length
// triangle      a             cos             unit normal   sin             b, c; w: lengths of b - a and c - a
struct Shape {
    vec4 anchor;
    vec4 axis;
    vec4 along_u;
    vec4 along_v;
};

// What the kernels that are chosen for precision read besides. `low` is what rounding to float took from a number.
struct FineShape {
    vec4 anchor_low;    // xyz: of Shape.anchor
    vec4 axis;          // xyz: a cylinder's axis, whose length is its height; else the unit normal
    vec4 axis_low;      // xyz
    vec4 along_u_low;   // xyz: of a triangle's b
    vec4 along_v_low;   // xyz: of its c
    vec4 point;         // xyz: of a round surface, nearest to the scene origin; w: 1 / radius
    vec4 point_normal;  // xyz: the outward normal there; w: a cylinder's point's height above its base
    vec4 point_normal_low; // xyz
};

struct Material {
    vec4 colour;     // rgb: reflectance; w: index of the picture that multiplies it, -1 for none
    vec4 ambient;    // rgb: reflectance for ambient light; w: 1 where it is the surface's colour instead
    vec4 specular;   // rgb; w: shininess
    vec4 emission;   // rgb: radiance; w: reflectance model
    vec4 mirror;     // rgb: mirror times its colour; w: mirror
    vec4 checker;    // rgb: the second colour; w: the pattern's size in metres, 0 for no pattern
    vec4 checker_first; // rgb: the first colour; w: metres a picture spans on a plane
    vec4 bending;    // n_i/n_t on entering, on leaving; (n_t/n_i)^2 - 1 on entering, on leaving
    vec4 absorption; // rgb: per metre, inside; w: index of the medium outside, -1 for air
    vec4 shadow_tint;       // rgb: what a chord lets through besides absorption; w: shadow kind
    vec4 shadow_absorption; // rgb: per metre, less that of the medium outside; w: transmit
    vec4 microfacet;        // alpha, metalness
};

// By kind: directional lights, points, spots, glowing spheres. Ambient and directional ambient light is summed by the host
// into u_ambient.
struct Light {
    vec4 position;    // xyz
    vec4 direction;   // xyz: unit, along which the light travels; w: 4 sin^2 of half the cone's half-angle
    vec4 ambient;     // rgb; w: exponent inside the cone
    vec4 diffuse;     // rgb; w: object that glows, -1 for none
    vec4 specular;    // rgb; w: least distance that attenuation is taken at, metres
    vec4 attenuation; // constant, linear (per metre), quadratic (per square metre)
};

struct Camera {
    vec4 eye;     // xyz; w: index of the medium that the eye is in, -1 for air
    vec4 right;   // half the picture's height to the right, at unit distance
    vec4 up;      // half the picture's height up
    vec4 forward; // unit; w: angle between the rays of neighbouring samples, radians
};

struct Sky {
    vec4 colour;  // rgb: radiance of a plain sky, of a gradient's nadir, or the factor of a picture
    vec4 horizon; // rgb: radiance of a gradient's horizon
    vec4 zenith;  // rgb: radiance of a gradient's zenith
    vec4 turn;    // cosine and sine of the picture's rotation; +1 or -1: the way u runs
};
