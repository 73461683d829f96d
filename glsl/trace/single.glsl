// No surface sends a ray on: the tree is one ray.

// Radiance (rgb) and the number of rays traced (a).
vec4 traceSingle(Path eye)
{
    return vec4(scatter(eye).radiance, 1.0);
}
