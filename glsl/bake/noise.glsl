// Noise for the painted pictures: gradients on an integer lattice, the same on every device.

const float pi = 3.14159265358979;

// Three scrambled words of a lattice cell. M. Jarzynski, M. Olano, "Hash functions for GPU rendering", 2020,
// pcg3d.
uvec3 scrambled(ivec3 cell)
{
    uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    return v + v.yzx * v.zxy;
}

// Three random numbers of a cell, 0..1.
vec3 randomOf(ivec3 cell)
{
    return vec3(scrambled(cell) >> 8u) / 16777216.0;
}

// The share that a cell's gradient has at an offset from that cell.
float gradientShare(ivec3 cell, vec3 offset)
{
    return dot(2.0 * randomOf(cell) - 1.0, offset);
}

// Gradient noise, about -1..1. K. Perlin, "Improving noise", 2002. It repeats every `period` cells; 0: never.
float tiledNoise(vec3 p, ivec3 period)
{
    ivec3 low = ivec3(floor(p));
    ivec3 high = low + 1;
    vec3 f = p - floor(p);
    ivec3 lows = low;
    if (period.x > 0) {
        ivec3 start = 1024 * period;
        lows = (low + start) % period;
        high = (high + start) % period;
    }
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float n000 = gradientShare(lows, f);
    float n100 = gradientShare(ivec3(high.x, lows.yz), f - vec3(1.0, 0.0, 0.0));
    float n010 = gradientShare(ivec3(lows.x, high.y, lows.z), f - vec3(0.0, 1.0, 0.0));
    float n110 = gradientShare(ivec3(high.xy, lows.z), f - vec3(1.0, 1.0, 0.0));
    float n001 = gradientShare(ivec3(lows.xy, high.z), f - vec3(0.0, 0.0, 1.0));
    float n101 = gradientShare(ivec3(high.x, lows.y, high.z), f - vec3(1.0, 0.0, 1.0));
    float n011 = gradientShare(ivec3(lows.x, high.yz), f - vec3(0.0, 1.0, 1.0));
    float n111 = gradientShare(high, f - 1.0);
    float back = mix(mix(n000, n100, w.x), mix(n010, n110, w.x), w.y);
    float front = mix(mix(n001, n101, w.x), mix(n011, n111, w.x), w.y);
    return mix(back, front, w.z);
}

// Gradient noise that never repeats.
float noise(vec3 p)
{
    return tiledNoise(p, ivec3(0));
}

// Octaves of noise, each twice as fine and half as strong as the one before; about -1..1.
float layeredNoise(vec3 p, int octaves)
{
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(p);
        p = 2.0 * p + 17.3;
        weight *= 0.5;
    }
    return 1.6 * sum;
}
