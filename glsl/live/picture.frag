// A picture as large as the window lets it be, in its own proportions.

uniform bool u_encode; // false the picture is linear radiance, to be encoded as sRGB

vec3 srgbFromLinear(vec3 linear)
{
    vec3 curved = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * linear, curved, vec3(greaterThan(linear, vec3(0.0031308))));
}

void mainImage(out vec4 colour, in vec2 pixel)
{
    vec2 size = iChannelResolution[0].xy;
    float scale = min(min(iResolution.x / size.x, iResolution.y / size.y), 1.0);
    vec2 place = (pixel - 0.5 * iResolution.xy) / scale + 0.5 * size;
    bool outside = any(lessThan(place, vec2(0.0))) || any(greaterThan(place, size));
    vec3 texel = outside ? vec3(0.1) : texture(iChannel0, place / size).rgb;
    colour = vec4(u_encode && !outside ? srgbFromLinear(clamp(texel, 0.0, 1.0)) : texel, 1.0);
}
