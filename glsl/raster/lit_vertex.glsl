// Light at a vertex or a facet, for a surface whose colour is only known in the pixel: what its colour multiplies, and what
// is added whatever its colour.

struct Lit {
    vec3 matt;
    vec3 shine;
};

Surface coloured(Surface surface, vec3 colour)
{
    Surface result = surface;
    result.colour = colour;
    return result;
}

#ifdef HAS_LIGHTS
// Every reflectance model is a straight line in the surface's colour: two points of it tell all.
Lit litBy(Light light, Incidence incidence, int glowing, Surface surface, Material material, Ray ray)
{
    Lit lit;
    lit.shine = lightReflected(light, incidence, glowing, coloured(surface, vec3(0.0)), material, ray, 0, false);
    lit.matt =
        lightReflected(light, incidence, glowing, coloured(surface, vec3(1.0)), material, ray, 0, false) - lit.shine;
    return lit;
}
#endif
