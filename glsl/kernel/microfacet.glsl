// Rough surfaces as a spread of tiny mirrors.

// Trowbridge and Reitz's distribution of microfacet normals (GGX), 1/sr, for unit vectors and alpha > 0; 0 where they point
// apart. Walter et al., "Microfacet models for refraction through rough surfaces", 2007, eq. 33, with the sine of the angle
// between them from Lagrange's identity: 1 - (n.h)^2 has lost it where alpha is small.
float microfacetDensity(vec3 normal, vec3 between, float alpha)
{
    float cosine = dot(normal, between);
    // n x h = n x (h - n), whose difference is all but exact: no compensated arithmetic is needed.
    vec3 sine = cross(normal, between - normal);
    float root = alpha / (dot(sine, sine) + (alpha * cosine) * (alpha * cosine));
    return cosine > 0.0 ? root * root / PI : 0.0;
}
