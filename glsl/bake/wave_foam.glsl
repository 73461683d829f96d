// The foam of the waves for wave.frag: where a crest's rim runs, and the lumps and claws that grow along it.

// A crest's rim: over the back to the tip (share 0.68), and on along the underside of the lip.
vec2 rim(int wave, float share)
{
    vec2 ends = wave == greatWave ? vec2(0.26, 0.70) : vec2(0.64, 0.60);
    vec4 over = flanks(wave, mix(ends.x, 1.0, min(share / 0.68, 1.0)));
    vec4 under = flanks(wave, mix(1.0, ends.y, clamp((share - 0.68) / 0.32, 0.0, 1.0)));
    return share < 0.68 ? over.zw : under.xy;
}

// Distance from the foam of a wave: a ribbon of lumps along the rim, claws thrown outward, claws that run
// down inside.
float foamDistance(vec2 p, int wave, int lumps)
{
    bool great = wave == greatWave;
    float nearest = 1.0e9;
    vec2 root = rim(wave, 0.0);
    for (int i = 0; i < lumps; ++i) {
        vec3 chance = randomOf(ivec3(i, 11 + wave, 5));
        float share = float(i + 1) / float(lumps);
        vec2 next = rim(wave, share);
        vec2 along = normalize(next - root);
        vec2 outward = vec2(-along.y, along.x);
        // The foam swells towards the tip and thins out at both ends of the rim.
        float swelling = smoothstep(0.0, 0.62, share) * (1.0 - 0.95 * smoothstep(0.72, 1.02, share));
        float size = great ? mix(0.35, 1.0, swelling) : 0.62 * max(1.0 - 1.45 * abs(share - 0.66), 0.12);
        float radius = size * (0.085 + 0.06 * chance.y);
        nearest =
            min(nearest, taperedSegment(p, root - 0.4 * radius * outward, next, 0.9 * radius, 0.5 * radius));
        vec2 thrown = great ? vec2(0.75, -0.45) : vec2(share < 0.68 ? -0.2 : 0.5, 0.1);
        thrown = normalize(0.8 * outward + thrown + 0.6 * (chance.xy - 0.5));
        float front = great ? 0.9 * exp(-60.0 * (share - 0.66) * (share - 0.66)) : -0.25;
        float reach = size * (0.16 + 0.16 * chance.z) * (1.0 + front);
        nearest =
            min(nearest, forkedClaw(p, root, reach * thrown, 0.45 + 0.4 * chance.x, 0.19 * reach + 0.01));
        vec2 inner = normalize((0.95 - share) * along - outward + 0.7 * (chance.zx - 0.5));
        float run = (great ? 0.16 + 0.26 * chance.y : size * (0.25 + 0.30 * chance.y)) *
                    (share > 0.66 && great ? 0.35 : 1.0);
        nearest = min(nearest, forkedClaw(p, root, run * inner, 0.35 - 0.9 * chance.z, 0.13 * run + 0.006));
        root = next;
    }
    return nearest;
}

// Foam with its own shadow in pale blue, away from a light in the upper left, and flecks in its thick.
vec3 foamed(vec3 below, vec2 p, float distance, float distanceTowardsLight)
{
    bool fleck = distance < -0.03 && noise(vec3(13.0 * p.x - 9.0 * p.y, 4.5 * (p.x + p.y), 3.0)) > 0.30;
    bool shaded = fleck || (distance > -0.045 && distanceTowardsLight < distance - 0.012);
    return inked(below, shaded ? paleBlue : foam, ink, distance, lineWidth);
}
