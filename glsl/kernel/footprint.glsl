// Which mip level of a picture a sample needs, and how a picture without repetition is kept within its edges. The level is
// explicit everywhere: implicit derivatives are undefined in divergent code and jump at the seam of a wrapped picture.

// The level at which the footprint, given as a share of the picture, is one texel on its longer side.
float pictureLevel(vec2 footprint, vec2 size)
{
    return log2(max(max(footprint.x * size.x, footprint.y * size.y), 1.0));
}

// Coordinates that stay half a texel of the coarsest level that is blended inside the picture, except along directions that
// wrap (1).
vec2 withinPicture(vec2 uv, vec2 wraps, float level, vec2 size)
{
    vec2 margin = min(0.5 * exp2(ceil(level)) / size, vec2(0.5));
    return mix(clamp(uv, margin, 1.0 - margin), uv, wraps);
}
