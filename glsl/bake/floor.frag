// A terrace of pale stone, octagons with slate-blue squares between them, that repeats in both directions:
// every noise has the picture's own period.
//   dioptre render glsl/bake/floor.frag --size 1024x1024 --spp 1 -o textures/floor.png

#include "bake/encode.glsl"
#include "bake/noise.glsl"

uniform vec2 u_resolution;
out vec4 o_colour;

const int tilesAcross = 4;
const int samplesAcross = 4;

// Octaves of noise over the picture, 0..1 in each direction, that repeat at its edges.
float stoneNoise(vec2 uv, int cells, int octaves, float layer)
{
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * tiledNoise(vec3(uv * float(cells), layer), ivec3(cells, cells, 64));
        cells *= 2;
        weight *= 0.5;
    }
    return 1.6 * sum;
}

// Distance from the joint of an octagon around the cell's middle, in cells, above 0 inside.
float insideOctagon(vec2 p)
{
    vec2 a = abs(p);
    return min(0.5 - max(a.x, a.y), (0.78 - a.x - a.y) / sqrt(2.0));
}

// Distance from the joint of the small square at the corner of four octagons, above 0 inside.
float insideCorner(vec2 p)
{
    vec2 a = 0.5 - abs(p);
    return (0.22 - a.x - a.y) / sqrt(2.0);
}

// Pale limestone, linear, with soft clouds and a few veins; no two tiles alike.
vec3 limestone(vec2 uv, ivec2 cell)
{
    vec3 chance = randomOf(ivec3(cell % tilesAcross, 7));
    float layer = floor(40.0 * chance.x) + 0.5;
    float cloud = stoneNoise(uv, 12, 4, layer);
    float vein = 1.0 - smoothstep(0.0, 0.05, abs(stoneNoise(uv, 9, 3, layer + 11.0)));
    vec3 stone = mix(vec3(0.50, 0.44, 0.35), vec3(0.60, 0.55, 0.47), 0.5 + 0.9 * cloud);
    stone *= 0.90 + 0.18 * chance.y;
    return mix(stone, vec3(0.38, 0.31, 0.23), 0.22 * vein);
}

// Slate blue, linear.
vec3 slate(vec2 uv)
{
    return vec3(0.035, 0.07, 0.14) * (1.0 + 0.5 * stoneNoise(uv, 24, 4, 3.5));
}

// The floor at a point of the picture, linear.
vec3 floorColour(vec2 uv)
{
    vec2 grid = uv * float(tilesAcross);
    ivec2 cell = ivec2(floor(grid));
    vec2 p = fract(grid) - 0.5;
    float octagon = insideOctagon(p);
    float corner = insideCorner(p);
    float inside = max(octagon, corner);
    vec3 stone = octagon > corner ? limestone(uv, cell) : slate(uv);
    // Edges are worn a little darker; the joint itself is mortar.
    stone *= mix(0.86, 1.0, smoothstep(0.010, 0.035, inside));
    vec3 mortar = vec3(0.24, 0.21, 0.18) * (1.0 + 0.3 * stoneNoise(uv, 32, 3, 21.5));
    return mix(mortar, stone, smoothstep(0.005, 0.011, inside));
}

void main()
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samplesAcross * samplesAcross; ++i) {
        vec2 offset = (vec2(i % samplesAcross, i / samplesAcross) + 0.5) / float(samplesAcross) - 0.5;
        sum += floorColour((gl_FragCoord.xy + offset) / u_resolution);
    }
    o_colour = vec4(encoded(sum / float(samplesAcross * samplesAcross)), 1.0);
}
