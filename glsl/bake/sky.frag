// A late afternoon sky as linear radiance, latitude-longitude: u = 0.5 + atan(x, -z) / 2 pi, v = 0.5 +
// latitude / pi. Everything depends on the direction alone, so that no seam can show. Radiances suit a
// picture without exposure: the sky stays below 1, only the glow of the sun and its disc rise above.
//   dioptre render glsl/bake/sky.frag --size 1536x768 --spp 1 --half -o textures/sky.exr

#include "bake/noise.glsl"

uniform vec2 u_resolution;
out vec4 o_colour;

const vec3 towardsSun = vec3(-0.702, 0.454, 0.549); // unit; still_life.toml has its light from there
const float sunRadius = 0.022; // radians, several times the true sun: no pixel can miss it
const float sunRadiance = 24.0;

// The direction that a point of the picture stands for.
vec3 directionOf(vec2 uv)
{
    float longitude = (2.0 * uv.x - 1.0) * pi;
    float latitude = (uv.y - 0.5) * pi;
    return vec3(sin(longitude) * cos(latitude), sin(latitude), -cos(longitude) * cos(latitude));
}

// The clear sky: blue overhead, pale and warm towards the horizon and towards the sun.
vec3 clearSky(vec3 d, float nearSun)
{
    float up = max(d.y, 0.0);
    vec3 zenith = vec3(0.075, 0.17, 0.36);
    vec3 middle = vec3(0.21, 0.39, 0.63);
    vec3 horizon = vec3(0.80, 0.69, 0.57);
    vec3 sky = mix(middle, zenith, smoothstep(0.12, 0.9, up));
    sky = mix(sky, horizon, exp(-8.0 * up));
    vec3 warm = vec3(0.95, 0.62, 0.34);
    return sky + warm * (0.35 * pow(nearSun, 6.0) + 0.9 * pow(nearSun, 60.0));
}

// Height of the far hills' ridge above the horizon, as a sine; `range` chooses one of several chains.
float ridge(vec3 d, float range)
{
    vec2 bearing = normalize(d.xz);
    vec3 p = vec3(bearing.x, range, bearing.y);
    return 0.018 + 0.028 * layeredNoise(3.0 * p, 2) + 0.005 * layeredNoise(9.0 * p, 2) - 0.012 * range;
}

// Two chains of hills under the sky, the farther the more of its light between.
vec3 hills(vec3 d, vec3 sky)
{
    float edge = 0.0055; // more than a texel, or the ridge would show steps
    vec3 haze = clearSky(normalize(vec3(d.x, 0.03, d.z)), max(dot(d, towardsSun), 0.0));
    vec3 far = mix(vec3(0.12, 0.20, 0.32), haze, 0.48);
    vec3 near = mix(vec3(0.06, 0.12, 0.21), haze, 0.24);
    vec3 land = mix(sky, far, 1.0 - smoothstep(-edge, edge, d.y - ridge(d, 0.0) - 0.014));
    return mix(land, near, 1.0 - smoothstep(-edge, edge, d.y - ridge(d, 1.0)));
}

// Share of a cloud sheet that covers a direction above the horizon; the sheet lies flat and thins out in the
// distance.
float cloudCover(vec3 d, vec2 shift)
{
    vec2 sheet = d.xz / (max(d.y, 0.0) + 0.10) + shift;
    vec3 p = vec3(sheet.x, 0.4, 1.4 * sheet.y);
    float bend = layeredNoise(0.7 * p + 4.0, 3);
    float cloud = layeredNoise(0.8 * p + 0.8 * bend + 2.0, 6);
    return smoothstep(-0.04, 0.42, cloud) * smoothstep(0.015, 0.10, d.y);
}

// The sky with its clouds: lit from the sun's side, grey-blue below.
vec3 upperSky(vec3 d)
{
    float nearSun = max(dot(d, towardsSun), 0.0);
    vec3 sky = clearSky(d, nearSun);
    float cover = cloudCover(d, vec2(0.0));
    float towards = cloudCover(d, 0.10 * normalize(towardsSun.xz));
    float lit = clamp(0.62 + 1.1 * (cover - towards), 0.0, 1.0);
    vec3 cloud = mix(vec3(0.40, 0.43, 0.51), vec3(0.95, 0.85, 0.74), lit);
    cloud += vec3(0.9, 0.6, 0.35) * 0.5 * pow(nearSun, 8.0);
    sky = mix(sky, cloud, 0.88 * cover);
    float angle = acos(min(dot(d, towardsSun), 1.0));
    float disc = 1.0 - smoothstep(0.7 * sunRadius, 1.3 * sunRadius, angle);
    return sky + sunRadiance * vec3(1.0, 0.82, 0.58) * disc;
}

// The ground below the horizon, smooth: haze near by the horizon, dark at the nadir.
vec3 lowerGround(vec3 d)
{
    return mix(vec3(0.30, 0.27, 0.24), vec3(0.07, 0.065, 0.06), smoothstep(0.0, 0.5, -d.y));
}

void main()
{
    vec3 d = directionOf(gl_FragCoord.xy / u_resolution);
    vec3 radiance = mix(lowerGround(d), hills(d, upperSky(d)), smoothstep(-0.012, 0.012, d.y));
    o_colour = vec4(radiance, 1.0);
}
