// Highlights of the classic reflectance models.

// log(1 + x) for -1 < x <= 0; GLSL has no log1p, and log(1 + x) loses all digits of a small x.
float logOnePlus(float x)
{
    float series = x * (1.0 + x * (-0.5 + x * (1.0 / 3.0 + x * (-0.25 + x * 0.2))));
    return abs(x) < 0.02 ? series : log(max(1.0 + x, 1.0e-30));
}

// (a.b)^exponent for unit a, b, and 0 where they point apart: from the sine, which keeps its digits near the peak. a x b =
// a x (b - a), whose difference is all but exact there.
float cosinePower(vec3 a, vec3 b, float exponent)
{
    vec3 sine = cross(a, b - a);
    float power = exp(0.5 * exponent * logOnePlus(-min(dot(sine, sine), 1.0)));
    return dot(a, b) > 0.0 ? power : 0.0;
}

// Phong: (V.R)^s. All vectors unit and pointing away from the surface.
float phongLobe(vec3 normal, vec3 toLight, vec3 toViewer, float shininess)
{
    return cosinePower(toViewer, reflect(-toLight, normal), shininess);
}

// Blinn: (N.H)^4s, the factor 4 making its highlight about as wide as Phong's.
float blinnLobe(vec3 normal, vec3 toLight, vec3 toViewer, float shininess)
{
    vec3 between = toLight + toViewer;
    float size = length(between);
    return size > 0.0 ? cosinePower(normal, between / size, 4.0 * shininess) : 0.0;
}
