// The bodies of three waves for wave.frag: guide points, outlines and the brush strokes that run up them.
// Shapes are drawn between two flanks, the face and the back, from the foot (share 0) to the tip (share 1).
// Lengths: the picture is 4 x 3.

// sRGB, as a printer mixes them.
const vec3 ink = vec3(0.075, 0.125, 0.25);
const vec3 prussian = vec3(0.105, 0.205, 0.39);
const vec3 midBlue = vec3(0.27, 0.45, 0.61);
const vec3 paleBlue = vec3(0.66, 0.76, 0.78);
const vec3 foam = vec3(0.96, 0.945, 0.885);
const float lineWidth = 0.0075;

// Guide points of three waves, foot to tip: xy on the face, zw on the back.
const int greatWave = 0;
const int nearWave = 1;
const int farSwell = 2;
const vec4 guides[27] =
    vec4[27](vec4(2.95, 0.50, -0.60, -0.60), vec4(2.35, 0.48, -0.50, 0.30), vec4(1.85, 0.62, -0.30, 1.00),
             vec4(1.50, 0.96, 0.05, 1.60), vec4(1.36, 1.40, 0.45, 2.12), vec4(1.44, 1.80, 0.90, 2.50),
             vec4(1.70, 2.05, 1.40, 2.70), vec4(2.02, 2.07, 1.92, 2.60), vec4(2.30, 1.86, 2.36, 2.12),
             vec4(4.60, -0.40, -0.60, -0.90), vec4(3.40, 0.00, -0.50, -0.40), vec4(2.60, 0.09, -0.30, 0.00),
             vec4(2.05, 0.22, 0.10, 0.22), vec4(1.70, 0.42, 0.50, 0.40), vec4(1.48, 0.66, 0.80, 0.60),
             vec4(1.36, 0.86, 1.02, 0.82), vec4(1.33, 0.98, 1.18, 0.98), vec4(1.37, 1.04, 1.37, 1.06),
             vec4(1.90, 0.30, 1.90, -0.50), vec4(2.30, 0.34, 2.30, -0.48), vec4(2.70, 0.42, 2.70, -0.46),
             vec4(3.10, 0.56, 3.10, -0.44), vec4(3.40, 0.72, 3.40, -0.42), vec4(3.65, 0.86, 3.65, -0.40),
             vec4(3.90, 0.96, 3.90, -0.38), vec4(4.10, 1.00, 4.10, -0.36), vec4(4.30, 1.00, 4.30, -0.34));

// Face (xy) and back (zw) of a wave at a share of the way from its foot to its tip.
vec4 flanks(int wave, float share)
{
    float place = clamp(8.0 * share, 0.0, 7.999);
    int i = int(place);
    int first = 9 * wave;
    return throughPoints(guides[first + max(i - 1, 0)], guides[first + i], guides[first + i + 1],
                         guides[first + min(i + 2, 8)], fract(place));
}

// A point within a wave: from foot to tip, and from its face (0) to its back (1).
vec2 flow(int wave, float share, float across)
{
    vec4 both = flanks(wave, share);
    return mix(both.xy, both.zw, across);
}

// Distance from a wave's outline, below 0 inside; its foot lies open outside the picture.
float bodyDistance(vec2 p, int wave)
{
    const int segments = 32;
    vec4 from = flanks(wave, 0.0);
    int crossings = crossesRight(p, from.xy, from.zw);
    float nearest = 1.0e9;
    for (int i = 1; i <= segments; ++i) {
        vec4 to = flanks(wave, float(i) / float(segments));
        nearest = min(nearest, taperedSegment(p, from.xy, to.xy, 0.0, 0.0));
        nearest = min(nearest, taperedSegment(p, from.zw, to.zw, 0.0, 0.0));
        crossings += crossesRight(p, from.xy, to.xy) + crossesRight(p, from.zw, to.zw);
        from = to;
    }
    crossings += crossesRight(p, from.xy, from.zw);
    return crossings % 2 == 1 ? -nearest : nearest;
}

// Brush strokes that run up a wave, mid-blue and pale in turn, swelling in their middle.
vec3 striped(vec3 colour, vec2 p, int wave, int strokes, float strength)
{
    const int segments = 22;
    for (int k = 0; k < strokes; ++k) {
        vec3 chance = randomOf(ivec3(k, wave, 3));
        float across = (float(k) + 0.35 + 0.4 * chance.x) / float(strokes);
        float begin = 0.02 + 0.18 * chance.y;
        float end = 0.80 + 0.18 * chance.z;
        float nearest = 1.0e9;
        vec2 from = flow(wave, begin, across);
        for (int i = 1; i <= segments; ++i) {
            float share = float(i) / float(segments);
            vec2 to = flow(wave, mix(begin, end, share), across);
            float width = strength * (0.25 + 0.75 * sin(pi * share)) * (1.0 - 0.55 * share);
            nearest = min(nearest, taperedSegment(p, from, to, width, width));
            from = to;
        }
        vec3 paint = k % 3 == 1 ? paleBlue : midBlue;
        colour = nearest < 0.0 ? paint : colour;
    }
    return colour;
}
