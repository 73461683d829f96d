// A great wave: our own homage to the woodblock prints of Edo, painted by a shader. From back to front: paper
// sky, a snow mountain, the far swell with boats, the great wave with its claws of foam, the near wave. The
// picture is 4 wide, 3 high.
//   dioptre render glsl/bake/wave.frag --size 1024x768 --spp 1 -o textures/wave.png

#include "bake/brush.glsl"
#include "bake/noise.glsl"
#include "bake/wave_body.glsl"
#include "bake/wave_foam.glsl"

uniform vec2 u_resolution;
out vec4 o_colour;

const int samplesAcross = 4;

// Paper sky, with the printer's bokashi: darker at the horizon and along the upper edge.
vec3 paperSky(vec2 p)
{
    vec3 sky = mix(vec3(0.70, 0.685, 0.63), vec3(0.905, 0.845, 0.715), smoothstep(0.45, 1.75, p.y));
    return mix(sky, vec3(0.83, 0.73, 0.585), 0.75 * smoothstep(2.3, 3.05, p.y));
}

// The mountain under its snow, far off.
vec3 mountain(vec3 below, vec2 p)
{
    float aside = p.x - 2.80;
    float ridge =
        0.47 + 0.66 * exp(-1.75 * max(abs(aside) - 0.035, 0.0)) + 0.008 * noise(vec3(9.0 * p.x, 0.0, 4.0));
    float radial = 5.0 * aside / (1.25 - p.y);
    float gully = abs(fract(radial + 0.5 * noise(vec3(1.7 * radial, 2.0, 6.0))) - 0.5);
    float snowLine = 0.78 + 0.22 * gully * (1.0 + noise(vec3(3.0 * radial, 5.0, 1.0))) + 0.10 * abs(aside);
    vec3 slope = mix(vec3(0.46, 0.55, 0.62), vec3(0.27, 0.365, 0.48), smoothstep(0.45, 0.85, p.y));
    return inked(below, p.y > snowLine ? foam : slope, ink, p.y - ridge, 0.75 * lineWidth);
}

// A long skiff, its ends drawn up, and the heads of its rowers.
vec3 skiff(vec3 below, vec2 p, vec2 middle, vec2 reach, float bend)
{
    vec3 colour = below;
    for (int i = -3; i < 3; ++i) {
        float share = (float(i) + 0.5) / 4.0;
        vec2 seat = clawPoint(middle, reach, -bend, share) + vec2(-0.006, 0.075);
        colour =
            inked(colour, prussian, ink, taperedSegment(p, seat, seat - vec2(0.0, 0.05), 0.024, 0.03), 0.0);
        colour = inked(colour, vec3(0.88, 0.73, 0.58), ink, length(p - seat) - 0.021, 0.6 * lineWidth);
    }
    float hull = min(claw(p, middle, reach, -bend, 0.05), claw(p, middle, -reach, bend, 0.05));
    return inked(colour, vec3(0.82, 0.69, 0.44), ink, hull, lineWidth);
}

// Drops of spray before the sky, ever fewer away from the tip.
vec3 sprayed(vec3 below, vec2 p)
{
    ivec2 cell = ivec2(floor(p / 0.075));
    vec3 chance = randomOf(ivec3(cell, 31));
    vec2 middle = (vec2(cell) + 0.25 + 0.5 * chance.xy) * 0.075;
    float far = length((middle - vec2(2.25, 2.05)) * vec2(0.85, 1.0));
    float radius = chance.z < 0.8 * exp(-3.0 * far * far) ? 0.005 + 0.013 * fract(37.0 * chance.z) : 0.0;
    return length(p - middle) < radius ? foam : below;
}

// The seal in the upper left corner: a lens and the ray that it bends.
vec3 sealed(vec3 below, vec2 p)
{
    vec2 q = p - vec2(0.30, 2.62);
    vec2 a = abs(q) - vec2(0.115, 0.175);
    float frame = max(a.x, a.y) - 0.012 * noise(vec3(14.0 * p, 2.0));
    vec3 colour = frame < 0.0 ? vec3(0.73, 0.20, 0.13) : below;
    float lens = max(length(q - vec2(0.14, 0.0)), length(q + vec2(0.14, 0.0))) - 0.185;
    float ray = abs(q.y - (q.x < 0.0 ? 0.08 : 0.08 - 1.1 * q.x)) - 0.009;
    bool cut = abs(lens) < 0.010 || (ray < 0.0 && a.x < -0.02);
    return cut && frame < -0.01 ? vec3(0.92, 0.86, 0.74) : colour;
}

// The picture at a point, sRGB.
vec3 painted(vec2 p)
{
    p += 0.010 * vec2(noise(vec3(3.5 * p, 1.0)), noise(vec3(3.5 * p, 8.0)));
    vec3 colour = sealed(sprayed(mountain(paperSky(p), p), p), p);
    float sea = 0.50 + 0.05 * sin(4.0 * p.x + 1.0);
    colour = inked(colour, p.y < sea - 0.07 ? prussian : midBlue, ink, p.y - sea, lineWidth);
    colour = skiff(colour, p, vec2(3.42, 0.72), vec2(0.46, 0.20), 0.12);
    colour =
        inked(colour, striped(prussian, p, farSwell, 5, 0.035), ink, bodyDistance(p, farSwell), lineWidth);
    colour =
        inked(colour, striped(prussian, p, greatWave, 11, 0.075), ink, bodyDistance(p, greatWave), lineWidth);
    vec2 light = 0.02 * vec2(-1.0, 1.3);
    colour = foamed(colour, p, foamDistance(p, greatWave, 44), foamDistance(p + light, greatWave, 44));
    colour = skiff(colour, p, vec2(2.52, 0.47), vec2(0.52, -0.05), 0.16);
    colour =
        inked(colour, striped(prussian, p, nearWave, 7, 0.035), ink, bodyDistance(p, nearWave), lineWidth);
    return foamed(colour, p, foamDistance(p, nearWave, 13), foamDistance(p + light, nearWave, 13));
}

void main()
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samplesAcross * samplesAcross; ++i) {
        vec2 offset = (vec2(i % samplesAcross, i / samplesAcross) + 0.5) / float(samplesAcross) - 0.5;
        sum += painted((gl_FragCoord.xy + offset) * vec2(4.0, 3.0) / u_resolution);
    }
    vec3 print = sum / float(samplesAcross * samplesAcross);
    vec2 grain = gl_FragCoord.xy / u_resolution;
    print *= 1.0 + 0.035 * layeredNoise(vec3(6.0 * grain.x, 90.0 * grain.y, 2.0), 3);
    o_colour = vec4(print, 1.0);
}
