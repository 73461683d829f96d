// From sums of samples to what a display shows: the same as a PNG holds.

uniform sampler2D u_sums;  // radiance in rgb, summed over samples
uniform sampler2D u_other_sums; // of another picture by as many samples
uniform bool u_is_difference;   // show how far the two are from each other
uniform float u_scale;     // of a sum: 1 over the samples, times 2^exposure
uniform int u_curve;       // how radiance becomes 0..1: see toneCurve()
uniform float u_gamma;     // 0: by the sRGB curve; below 0: not encoded; else by the power 1/gamma

out vec4 o_colour;

// none: cut at 1; 1: Reinhard et al. 2002, eq. 3; 2: Narkowicz's fit of the ACES curve, 2016.
vec3 toneCurve(vec3 x)
{
    if (u_curve == 1)
        return x / (1.0 + x);
    if (u_curve == 2)
        return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    return x;
}

// IEC 61966-2-1.
vec3 srgbFromLinear(vec3 linear)
{
    return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, vec3(greaterThan(linear, vec3(0.0031308))));
}

void main()
{
    vec3 sum = texelFetch(u_sums, ivec2(gl_FragCoord.xy), 0).rgb;
    if (u_is_difference)
        sum = abs(sum - texelFetch(u_other_sums, ivec2(gl_FragCoord.xy), 0).rgb);
    // A number that is none is shown as 0, and the largest as 1.
    vec3 radiance = clamp(mix(vec3(0.0), u_scale * sum, vec3(equal(sum, sum))), 0.0, 1e18);
    vec3 shown = clamp(toneCurve(radiance), 0.0, 1.0);
    if (u_gamma == 0.0)
        shown = srgbFromLinear(shown);
    else if (u_gamma > 0.0)
        shown = pow(shown, vec3(1.0 / u_gamma));
    o_colour = vec4(shown, 1.0);
}
