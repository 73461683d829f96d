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
// (cosine)^exponent inside the cone, 0 outside: by the chord between the unit vectors, as a small angle's cosine has lost it.
float coneStrength(Light light, vec3 towards)
{
    vec3 chord = towards + light.direction.xyz;
    float exponent = light.ambient.w;
    float strength = exponent == 0.0 ? 1.0 : cosinePower(light.direction.xyz, -towards, exponent);
    return dot(chord, chord) <= light.direction.w ? strength : 0.0;
}
#endif

#ifdef HAS_DIRECTIONAL_LIGHT
Incidence directionalIncidence(Light light)
{
    Incidence incidence;
    incidence.towards = -light.direction.xyz;
    incidence.distance = FAR_AWAY;
    incidence.strength = 1.0;
    return incidence;
}
#endif

#ifdef HAS_PLACED_LIGHT
Incidence pointIncidence(Light light, vec3 position)
{
    vec3 offset = light.position.xyz - position;
    float distance = length(offset);
    Incidence incidence;
    incidence.towards = distance > 0.0 ? offset / distance : vec3(0.0, 1.0, 0.0);
    incidence.distance = distance;
    incidence.strength = attenuation(light, distance);
    return incidence;
}
#endif

#ifdef HAS_SPOT_LIGHT
Incidence spotIncidence(Light light, vec3 position)
{
    Incidence incidence = pointIncidence(light, position);
    incidence.strength *= coneStrength(light, incidence.towards);
    return incidence;
}
#endif

#ifdef HAS_ANY_AMBIENT
// What a surface reflects of ambient light.
vec3 ambientColour(Surface surface, Material material)
{
    return material.ambient.w > 0.0 ? surface.colour : material.ambient.xyz;
}
#endif

#ifdef HAS_HIGHLIGHT
// Highlight of the material's model, times its specular colour.
vec3 highlight(Surface surface, Material material, vec3 toLight, vec3 toViewer)
{
    int model = int(material.emission.w);
    float lobe = 0.0;
#ifdef HAS_PHONG
    float phong = phongLobe(surface.normal, toLight, toViewer, material.specular.w);
    lobe = model == MODEL_PHONG ? phong : lobe;
#endif
#ifdef HAS_BLINN
    float blinn = blinnLobe(surface.normal, toLight, toViewer, material.specular.w);
    lobe = model == MODEL_BLINN ? blinn : lobe;
#endif
    vec3 reflected = lobe * material.specular.xyz;
#ifdef HAS_MICROFACET
    vec3 head_on = mix(material.specular.xyz, surface.colour, material.microfacet.y);
    vec3 facets = microfacetLobe(surface.normal, toLight, toViewer, material.microfacet.x, head_on);
    reflected = model == MODEL_MICROFACET ? facets : reflected;
#endif
    return reflected;
}
#endif

#ifdef HAS_LIGHTS
// Radiance towards the viewer from one light by diffuse and specular reflection; `glowing` is the object whose light it is,
// -1 for none.
vec3 lightReflected(Light light, Incidence incidence, int glowing, Surface surface, Material material, Ray ray,
                    int object, bool inside)
{
    float cosine = dot(surface.normal, incidence.towards);
    vec3 reflected = light.diffuse.xyz * surface.colour * max(cosine, 0.0);
#ifdef HAS_MICROFACET
    // Metals have no matt part.
    reflected *= int(material.emission.w) == MODEL_MICROFACET ? 1.0 - material.microfacet.y : 1.0;
#endif
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
    arriving *= min(lightThrough(toLight, incidence.distance, glowing), vec3(1.0));
#endif
    return arriving * reflected;
}
#endif

#ifdef HAS_LIGHT_AMBIENT
// Radiance towards the viewer from the ambient part of a point or spot light.
vec3 ambientReflected(Light light, Incidence incidence, Surface surface, Material material)
{
    return incidence.strength * light.ambient.xyz * ambientColour(surface, material);
}
#endif

#ifdef HAS_LIGHT_LOOPS
// Radiance towards the viewer from every light. They stand in u_lights by kind, so that no light is asked what it is.
vec3 lightsReflected(Surface surface, Material material, Ray ray, int object, bool inside)
{
    vec3 radiance = vec3(0.0);
#ifdef HAS_DIRECTIONAL_LIGHT
    for (int i = 0; i < FIRST_POINT_LIGHT; ++i)
        radiance += lightReflected(u_lights[i], directionalIncidence(u_lights[i]), -1, surface, material, ray, object,
                                   inside);
#endif
#ifdef HAS_POINT_LIGHT
    for (int i = FIRST_POINT_LIGHT; i < FIRST_SPOT_LIGHT; ++i) {
        Incidence incidence = pointIncidence(u_lights[i], surface.position);
        radiance += lightReflected(u_lights[i], incidence, -1, surface, material, ray, object, inside);
#ifdef HAS_LIGHT_AMBIENT
        radiance += ambientReflected(u_lights[i], incidence, surface, material);
#endif
    }
#endif
#ifdef HAS_SPOT_LIGHT
    for (int i = FIRST_SPOT_LIGHT; i < FIRST_GLOW; ++i) {
        Incidence incidence = spotIncidence(u_lights[i], surface.position);
        radiance += lightReflected(u_lights[i], incidence, -1, surface, material, ray, object, inside);
#ifdef HAS_LIGHT_AMBIENT
        radiance += ambientReflected(u_lights[i], incidence, surface, material);
#endif
    }
#endif
#ifdef HAS_GLOW
    for (int i = FIRST_GLOW; i < LIGHT_COUNT; ++i)
        radiance += lightReflected(u_lights[i], pointIncidence(u_lights[i], surface.position),
                                   int(u_lights[i].diffuse.w), surface, material, ray, object, inside);
#endif
    return radiance;
}
#endif
