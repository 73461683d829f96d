// Unpolarised Fresnel transmittance of a smooth interface by its own formula, for c, n and m as in dielectric.glsl: it adds
// up to 1 with the reflectance, and keeps its digits where little goes through. 0 under total internal reflection.
// Cook and Torrance, "A reflectance model for computer graphics", 1982, with g = sqrt(m + c^2).
float fresnelTransmittance(float c, float n, float m)
{
    float g = sqrt(max(m + c * c, 0.0));
    float perpendicular = 1.0 / (c + g);
    float parallel = n / (n * n * c + g);
    float share = 2.0 * c * g * (perpendicular * perpendicular + parallel * parallel);
    return m == 0.0 ? 1.0 : (m + c * c <= 0.0 ? 0.0 : share);
}
