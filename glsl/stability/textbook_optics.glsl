// What textbooks print for light, for the stability suite to hold ours against. No picture is made with it.

// Whether nothing gets through an interface of n = n_t / n_i: Snell's law by the squared sine.
bool textbookTotal(float c, float n)
{
    return (1.0 - c * c) / (n * n) >= 1.0;
}

// Reflectance and transmittance for n = n_t / n_i: Pharr, Jakob, Humphreys, "Physically Based Rendering", FrDielectric.
vec2 textbookFresnel(float c, float n)
{
    float sine2 = (1.0 - c * c) / (n * n);
    float inner = sqrt(max(1.0 - sine2, 0.0));
    float parallel = (n * c - inner) / (n * c + inner);
    float perpendicular = (c - n * inner) / (c + n * inner);
    float passedParallel = 2.0 * c / (n * c + inner);
    float passed = 2.0 * c / (c + n * inner);
    float share = 0.5 * n * inner / c * (passedParallel * passedParallel + passed * passed);
    return sine2 >= 1.0 ? vec2(1.0, 0.0) : vec2(0.5 * (parallel * parallel + perpendicular * perpendicular), share);
}

// Walter et al. 2007, as most renderers write it.
float textbookMicrofacet(vec3 normal, vec3 between, float alpha)
{
    float cosine = dot(normal, between);
    float alpha2 = alpha * alpha;
    float denominator = cosine * cosine * (alpha2 - 1.0) + 1.0;
    return cosine > 0.0 ? alpha2 / (PI * denominator * denominator) : 0.0;
}

float textbookLobe(vec3 a, vec3 b, float exponent)
{
    return pow(max(dot(a, b), 0.0), exponent);
}

// Shading Language examples of the OpenGL 2 lighting model: cosine against cosine.
float textbookCone(vec3 axis, vec3 fromLight, float cutoffCosine, float exponent)
{
    float cosine = dot(axis, fromLight);
    return cosine >= cutoffCosine ? pow(max(cosine, 0.0), exponent) : 0.0;
}

float textbookAttenuation(vec3 coefficients, float distance)
{
    return 1.0 / (coefficients.x + coefficients.y * distance + coefficients.z * distance * distance);
}

vec2 textbookLatLong(vec3 direction)
{
    vec3 unit = normalize(direction);
    float longitude = acos(clamp(unit.z / length(unit.xz), -1.0, 1.0));
    return vec2(0.5 + (unit.x < 0.0 ? -longitude : longitude) / (2.0 * PI), 0.5 + asin(unit.y) / PI);
}
