// The light that a surface sends to the viewer from the scene's lights.

// Light on its way to a point.
struct Incidence {
    vec3 towards;   // unit, from the point to the light
    float distance; // metres; FAR_AWAY for a directional light
    float strength; // attenuation and cone
};

#ifdef HAS_PLACED_LIGHT
// 1 / (c + l d + q d^2), d never below the light's own size.
float attenuation(Light light, float distance)
{
    float d = max(distance, light.specular.w);
    return 1.0 / (light.attenuation.x + d * (light.attenuation.y + d * light.attenuation.z));
}
#endif

#ifdef HAS_SPOT_LIGHT
// (cosine)^exponent inside the cone, 0 outside; the base is clamped before the power.
float coneStrength(Light light, vec3 towards)
{
    float cosine = -dot(towards, light.direction.xyz);
    float exponent = light.ambient.w;
    float strength = exponent == 0.0 ? 1.0 : pow(max(cosine, 1.0e-6), exponent);
    return cosine >= light.direction.w ? strength : 0.0;
}
#endif

Incidence incidenceOf(Light light, vec3 position)
{
    Incidence incidence;
    incidence.towards = -light.direction.xyz;
    incidence.distance = FAR_AWAY;
    incidence.strength = 1.0;
#ifdef HAS_PLACED_LIGHT
    int kind = int(light.position.w);
    if (kind != LIGHT_DIRECTIONAL) {
        vec3 offset = light.position.xyz - position;
        float distance = length(offset);
        incidence.towards = distance > 0.0 ? offset / distance : vec3(0.0, 1.0, 0.0);
        incidence.distance = distance;
        incidence.strength = attenuation(light, distance);
    }
#endif
#ifdef HAS_SPOT_LIGHT
    if (kind == LIGHT_SPOT)
        incidence.strength *= coneStrength(light, incidence.towards);
#endif
    return incidence;
}

#ifdef HAS_HIGHLIGHT
// Highlight of the material's model, times its specular colour.
vec3 highlight(Surface surface, Material material, vec3 toLight, vec3 toViewer)
{
    float lobe = 0.0;
#ifdef HAS_PHONG
    if (int(material.emission.w) == MODEL_PHONG)
        lobe = phongLobe(surface.normal, toLight, toViewer, material.specular.w);
#endif
#ifdef HAS_BLINN
    if (int(material.emission.w) == MODEL_BLINN)
        lobe = blinnLobe(surface.normal, toLight, toViewer, material.specular.w);
#endif
    return lobe * material.specular.xyz;
}
#endif

// Radiance towards the viewer by ambient, diffuse and specular reflection.
vec3 localRadiance(Surface surface, Material material, Ray ray, int object, bool inside)
{
    vec3 radiance = vec3(0.0);
#ifdef HAS_ANY_AMBIENT
    vec3 ambientColour = material.ambient.w > 0.0 ? surface.colour : material.ambient.xyz;
#endif
#ifdef HAS_AMBIENT
    radiance += u_ambient * ambientColour;
#endif
#ifdef HAS_LIGHTS
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        Light light = u_lights[i];
        Incidence incidence = incidenceOf(light, surface.position);
#ifdef HAS_LIGHT_AMBIENT
        radiance += incidence.strength * light.ambient.xyz * ambientColour;
#endif
        float cosine = dot(surface.normal, incidence.towards);
        vec3 reflected = light.diffuse.xyz * surface.colour * max(cosine, 0.0);
#ifdef HAS_HIGHLIGHT
        reflected += light.specular.xyz * highlight(surface, material, incidence.towards, -ray.direction);
#endif
        vec3 arriving = vec3(cosine > 0.0 ? incidence.strength : 0.0);
#ifdef HAS_SHADOWS
        Ray toLight;
        toLight.origin = surface.position;
        toLight.direction = incidence.towards;
        toLight.from = 2 * object + (inside ? 1 : 0);
        // Media stand in each other rightly only where the scene says so: never more than all of the light.
        arriving *= min(lightThrough(toLight, incidence.distance, int(light.diffuse.w)), vec3(1.0));
#endif
        radiance += arriving * reflected;
    }
#endif
    return radiance;
}
