// The surface between two optical media. c is the cosine of incidence, n = n_t / n_i, m = n^2 - 1; both from the host, in
// double precision. g = sqrt(m + c^2) = n times the cosine of refraction.

// Unpolarised Fresnel reflectance of a smooth interface; 1 under total internal reflection.
// Cook and Torrance, "A reflectance model for computer graphics", 1982, rewritten without the difference g - c.
float fresnelReflectance(float c, float m)
{
    float gg = m + c * c;
    float g = sqrt(max(gg, 0.0));
    float ss = (1.0 - c) * (1.0 + c);
    float s_over = c + g;
    float perpendicular = m / (s_over * s_over);
    float ratio = (c * g - ss) / (c * g + ss);
    float reflectance = 0.5 * perpendicular * perpendicular * (1.0 + ratio * ratio);
    return m == 0.0 ? 0.0 : (gg <= 0.0 ? 1.0 : reflectance);
}

// Snell's law: the unit direction behind the interface; `normal` faces the incoming ray, eta = n_i / n_t. Only to be used
// where fresnelReflectance is below 1.
vec3 refractedDirection(vec3 direction, vec3 normal, float c, float eta, float m)
{
    float g = sqrt(max(m + c * c, 0.0));
    return normalize(eta * (direction + (c - g) * normal));
}
