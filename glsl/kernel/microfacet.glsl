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

// The light that rough mirrors send to the viewer, of 1 that a white Lambertian surface would show head-on; all vectors unit
// and pointing away from the surface, alpha > 0. `head_on` is their reflectance along the normal, Schlick's formula leads from
// there to 1. Facets hide each other as Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3
// (2014), eq. 99, has it.
vec3 microfacetLobe(vec3 normal, vec3 toLight, vec3 toViewer, float alpha, vec3 head_on)
{
    vec3 between = normalize(toLight + toViewer);
    float light = max(dot(normal, toLight), 0.0);
    float viewer = max(dot(normal, toViewer), 0.0);
    float squared = alpha * alpha;
    float hidden = light * sqrt(squared + viewer * viewer * (1.0 - squared)) +
                   viewer * sqrt(squared + light * light * (1.0 - squared));
    float away = clamp(1.0 - dot(toViewer, between), 0.0, 1.0);
    float grazing = away * away * away * away * away;
    vec3 reflectance = head_on + (1.0 - head_on) * grazing;
    // Over pi, as all light here is in units of what a Lambertian surface shows.
    float share = PI * microfacetDensity(normal, between, alpha) * 0.5 * light / hidden;
    return light > 0.0 ? share * reflectance : vec3(0.0);
}
