// What a surface lets through, for rays and for facets.

#ifdef HAS_MIRROR_RAY
// The share of light that goes through a surface instead of coming back from within it.
float transmitOf(Material material)
{
#ifdef HAS_REFRACTION
    return material.shadow_absorption.w;
#else
    return 0.0;
#endif
}
#endif
