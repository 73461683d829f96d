// A planet of our own as a latitude-longitude picture: u = 0.5 + atan(x, z) / 2 pi, v = 0.5 + latitude / pi.
// All is painted by noise in space, on the sphere itself, so that neither the date line nor the poles show a
// seam.
//   dioptre render glsl/bake/planet.frag --size 1024x512 --spp 1 -o textures/planet.png

#include "bake/encode.glsl"
#include "bake/noise.glsl"

uniform vec2 u_resolution;
out vec4 o_colour;

// The point of the unit sphere that a point of the picture stands for.
vec3 placeOnSphere(vec2 uv)
{
    float longitude = (2.0 * uv.x - 1.0) * pi;
    float latitude = (uv.y - 0.5) * pi;
    return vec3(sin(longitude) * cos(latitude), sin(latitude), cos(longitude) * cos(latitude));
}

// Height of the land above the sea, about -1..1; coasts are bent by a coarser noise.
float heightOf(vec3 place)
{
    vec3 bend = vec3(noise(2.1 * place + 5.2), noise(2.1 * place + 1.7), noise(2.1 * place + 9.4));
    return layeredNoise(1.55 * place + 0.55 * bend + vec3(0.35, 7.1, 3.6), 7) - 0.04;
}

// Land, linear: dunes in the dry belts, woods where it rains, bare rock above.
vec3 landColour(vec3 place, float height)
{
    float latitude = abs(place.y);
    float rain = 0.5 + 0.5 * cos(9.0 * latitude) + 0.7 * layeredNoise(3.0 * place + 30.0, 4);
    float grain = 1.0 + 0.35 * layeredNoise(14.0 * place, 4);
    vec3 dune = vec3(0.52, 0.36, 0.17);
    vec3 steppe = vec3(0.25, 0.24, 0.08);
    vec3 wood = vec3(0.055, 0.13, 0.035);
    vec3 rock = vec3(0.24, 0.19, 0.15);
    vec3 land = mix(dune, steppe, smoothstep(0.1, 0.45, rain));
    land = mix(land, wood, smoothstep(0.4, 0.85, rain));
    land = mix(land, vec3(0.2, 0.2, 0.14), smoothstep(0.78, 0.92, latitude));
    return grain * mix(land, rock, smoothstep(0.22, 0.5, height));
}

// Sea, linear: turquoise over the shelves, dark over the deeps.
vec3 seaColour(float height)
{
    vec3 sea = mix(vec3(0.012, 0.09, 0.20), vec3(0.004, 0.025, 0.085), smoothstep(-0.08, -0.45, height));
    return mix(sea, vec3(0.05, 0.27, 0.30), smoothstep(-0.07, 0.0, height));
}

// Share of the sky that clouds cover: bands of weather, drawn out along the parallels and curled.
float cloudCover(vec3 place)
{
    vec3 p = place * vec3(2.2, 3.6, 2.2);
    vec3 curl = vec3(layeredNoise(p + 3.1, 3), layeredNoise(p + 8.3, 3), layeredNoise(p + 14.7, 3));
    float weather =
        layeredNoise(1.3 * p + 1.1 * curl, 6) + 0.10 * cos(13.0 * place.y) - 0.10 * cos(5.0 * place.y);
    return 0.92 * smoothstep(0.06, 0.42, weather);
}

void main()
{
    vec3 place = placeOnSphere(gl_FragCoord.xy / u_resolution);
    float height = heightOf(place);
    // The slope towards a light in the north-west shades the ranges.
    vec3 northWest = place + 0.006 * normalize(vec3(-place.z, 1.2, place.x));
    float slope = clamp(1.0 + 9.0 * (height - heightOf(northWest)), 0.6, 1.45);
    vec3 ground =
        mix(seaColour(height), slope * landColour(place, height), smoothstep(-0.004, 0.008, height));
    float ice = abs(place.y) + 0.10 * layeredNoise(5.0 * place + 60.0, 5) + 0.12 * max(height, 0.0);
    ground = mix(ground, vec3(0.80, 0.86, 0.90), smoothstep(0.945, 0.97, ice));
    float shade = cloudCover(normalize(place + 0.012 * vec3(place.z, 0.6, -place.x)));
    ground *= 1.0 - 0.4 * shade;
    vec3 colour = mix(ground, vec3(0.88, 0.90, 0.92), cloudCover(place));
    o_colour = vec4(encoded(colour), 1.0);
}
