// Brushes of a woodblock print: strokes that swell and taper, hooked claws of foam, curves through guide
// points, ink lines. A distance is below 0 inside; lengths are in units of the picture.

// Distance from a segment whose half-width goes from one end's to the other's.
float taperedSegment(vec2 p, vec2 from, vec2 to, float fromWidth, float toWidth)
{
    vec2 along = to - from;
    float share = clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
    return length(p - from - share * along) - mix(fromWidth, toWidth, share);
}

// A claw's point at a share of its length: it sets out along `reach` and bends aside, to the right for bend >
// 0.
vec2 clawPoint(vec2 root, vec2 reach, float bend, float share)
{
    return root + share * reach + bend * share * share * vec2(reach.y, -reach.x);
}

// Distance from a claw that narrows to a point; far from it only that it is far.
float claw(vec2 p, vec2 root, vec2 reach, float bend, float width)
{
    bool far = length(p - root) > (1.0 + abs(bend)) * length(reach) + width + 0.05;
    int segments = far ? 0 : 5;
    float nearest = 1.0e9;
    vec2 from = root;
    float fromWidth = width;
    for (int i = 1; i <= segments; ++i) {
        float share = float(i) / float(segments);
        vec2 to = clawPoint(root, reach, bend, share);
        float toWidth = width * (1.0 - share * share);
        nearest = min(nearest, taperedSegment(p, from, to, fromWidth, toWidth));
        from = to;
        fromWidth = toWidth;
    }
    return nearest;
}

// Distance from a claw with two smaller ones that fork from it, as foam does at every scale.
float forkedClaw(vec2 p, vec2 root, vec2 reach, float bend, float width)
{
    float size = length(reach);
    int claws = length(p - root) > 2.6 * size + 0.05 ? 0 : 3;
    vec2 aside = vec2(reach.y, -reach.x) * sign(bend);
    float nearest = 1.0e9;
    for (int i = 0; i < claws; ++i) {
        vec2 start = root;
        vec2 way = reach;
        if (i > 0) {
            start = clawPoint(root, reach, bend, i == 1 ? 0.35 : 0.62);
            way = i == 1 ? 0.46 * reach - 0.34 * aside : 0.30 * reach + 0.32 * aside;
        }
        float scale = i == 0 ? 1.0 : 0.65 - 0.1 * float(i);
        nearest = min(nearest, claw(p, start, way, (1.0 + 0.4 * float(i)) * bend, scale * width));
    }
    return nearest;
}

// A curve through b and c, between them; a and d are its neighbours. E. Catmull, R. Rom, 1974.
vec4 throughPoints(vec4 a, vec4 b, vec4 c, vec4 d, float share)
{
    vec4 cubic = share * (3.0 * (b - c) + d - a) + 2.0 * a - 5.0 * b + 4.0 * c - d;
    return b + 0.5 * share * (c - a + share * cubic);
}

// 1 where the line from p straight to the right crosses an edge: an odd count means inside.
int crossesRight(vec2 p, vec2 from, vec2 to)
{
    bool spans = (from.y > p.y) != (to.y > p.y);
    float x = from.x + (to.x - from.x) * (p.y - from.y) / (spans ? to.y - from.y : 1.0);
    return spans && x > p.x ? 1 : 0;
}

// A colour laid over what is below, with an ink line on its rim.
vec3 inked(vec3 below, vec3 colour, vec3 ink, float distance, float lineWidth)
{
    vec3 filled = distance < 0.0 ? colour : below;
    return abs(distance) < lineWidth ? ink : filled;
}
