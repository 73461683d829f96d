// How uncertainty travels along a ray: rays as thin pencils, after the paraxial equations of curved mirrors and interfaces
// (Gaspard and Rice, "Scattering from a classically chaotic repellor", 1989, for the mirrors).

// What the origin and the direction of a ray may be off by, across it. Both signed: a concave mirror takes back what a convex
// one added.
struct Blur {
    float offset; // metres
    float angle;  // radians
};

Blur blurOf(float offset, float angle)
{
    Blur blur;
    blur.offset = offset;
    blur.angle = angle;
    return blur;
}

// Across the ray after t metres, with what rounding of the crossing adds to it.
float blurAcross(Blur blur, float t, float rounding)
{
    float across = blur.offset + t * blur.angle;
    return across + (across < 0.0 ? -rounding : rounding);
}

// After a mirror met at an angle of that cosine; curvature, 1/m, is positive where the surface is convex to the ray.
Blur blurMirrored(Blur blur, float across, float cosine, float curvature)
{
    return blurOf(across, blur.angle + 2.0 * curvature * across / cosine);
}

// After an interface, of eta = n_i / n_t, that the ray leaves at an angle whose cosine is `through`.
Blur blurRefracted(Blur blur, float across, float cosine, float through, float eta, float curvature)
{
    float spread = eta * cosine / through;
    return blurOf(across * through / cosine, spread * blur.angle + (spread - 1.0) * curvature * across / cosine);
}
