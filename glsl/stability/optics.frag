// Runs one formula of the product's optics over a table of inputs, one row to a pixel. One of HAS_CRITICAL, HAS_FRESNEL,
// HAS_MICROFACET, HAS_LOBE, HAS_CONE, HAS_DISTANCE and HAS_DIRECTION chooses it; HAS_TEXTBOOK takes the books' in its place.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/dielectric.glsl"
#include "kernel/transmittance.glsl"
#include "kernel/microfacet.glsl"
#include "kernel/lobe.glsl"
#include "kernel/lat_long.glsl"
#include "trace/light.glsl"
#include "stability/textbook_optics.glsl"

uniform sampler2D u_rows; // the texels of a row lie u_height apart, one above the other
uniform int u_height;
out vec4 o_answer;

vec4 texel(int which)
{
    return texelFetch(u_rows, ivec2(gl_FragCoord.xy) + ivec2(0, which * u_height), 0);
}

#ifdef HAS_CRITICAL
// 0: direction, n_t / n_i; 1: normal, (n_t / n_i)^2 - 1. x: 1 where all is reflected.
vec4 answerOfRow()
{
    float c = clamp(-dot(texel(0).xyz, texel(1).xyz), 0.0, 1.0);
#ifdef HAS_TEXTBOOK
    bool total = textbookTotal(c, texel(0).w);
#else
    bool total = fresnelReflectance(c, texel(1).w) == 1.0;
#endif
    return vec4(total ? 1.0 : 0.0, 0.0, 0.0, 0.0);
}
#endif

#ifdef HAS_FRESNEL
// 0: cosine, n_t / n_i, (n_t / n_i)^2 - 1. x: reflectance, y: transmittance.
vec4 answerOfRow()
{
#ifdef HAS_TEXTBOOK
    return vec4(textbookFresnel(texel(0).x, texel(0).y), 0.0, 0.0);
#else
    return vec4(fresnelReflectance(texel(0).x, texel(0).z),
                fresnelTransmittance(texel(0).x, texel(0).y, texel(0).z), 0.0, 0.0);
#endif
}
#endif

#ifdef HAS_MICROFACET
// 0: normal, alpha; 1: half vector. x: density.
vec4 answerOfRow()
{
#ifdef HAS_TEXTBOOK
    float density = textbookMicrofacet(texel(0).xyz, texel(1).xyz, texel(0).w);
#else
    float density = microfacetDensity(texel(0).xyz, texel(1).xyz, texel(0).w);
#endif
    return vec4(density, 0.0, 0.0, 0.0);
}
#endif

#ifdef HAS_LOBE
// 0: unit vector, exponent; 1: unit vector. x: cosine to that power.
vec4 answerOfRow()
{
#ifdef HAS_TEXTBOOK
    float power = textbookLobe(texel(0).xyz, texel(1).xyz, texel(0).w);
#else
    float power = cosinePower(texel(0).xyz, texel(1).xyz, texel(0).w);
#endif
    return vec4(power, 0.0, 0.0, 0.0);
}
#endif

#ifdef HAS_CONE
// 0: light, exponent; 1: axis, Light.direction.w; 2: place, cosine of the cutoff. x: strength.
vec4 answerOfRow()
{
    vec3 offset = texel(2).xyz - texel(0).xyz;
#ifdef HAS_TEXTBOOK
    float strength = textbookCone(texel(1).xyz, normalize(offset), texel(2).w, texel(0).w);
#else
    Light light;
    light.position = texel(0);
    light.direction = texel(1);
    light.ambient = texel(0);
    light.specular = vec4(0.0, 0.0, 0.0, NEAREST_LIGHT);
    light.attenuation = vec4(1.0, 0.0, 0.0, 0.0);
    float strength = spotIncidence(light, texel(2).xyz).strength;
#endif
    return vec4(strength, 0.0, 0.0, 0.0);
}
#endif

#ifdef HAS_DISTANCE
// 0: light, least distance; 1: coefficients; 2: place. x: strength, yzw: towards the light.
vec4 answerOfRow()
{
#ifdef HAS_TEXTBOOK
    vec3 offset = texel(0).xyz - texel(2).xyz;
    return vec4(textbookAttenuation(texel(1).xyz, length(offset)), normalize(offset));
#else
    Light light;
    light.position = texel(0);
    light.specular = texel(0);
    light.attenuation = texel(1);
    Incidence incidence = pointIncidence(light, texel(2).xyz);
    return vec4(incidence.strength, incidence.towards);
#endif
}
#endif

#ifdef HAS_DIRECTION
// 0: direction. xy: place on the map.
vec4 answerOfRow()
{
#ifdef HAS_TEXTBOOK
    return vec4(textbookLatLong(texel(0).xyz), 0.0, 0.0);
#else
    return vec4(latLong(texel(0).xyz), 0.0, 0.0);
#endif
}
#endif

void main()
{
    o_answer = answerOfRow();
}
