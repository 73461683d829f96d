// Views of what a pixel's ray meets first, as data in place of light: no lights, no pictures, no further rays.

// Data (rgb, 0 where nothing is met) and the one ray traced (a).
vec4 firstHit(Path eye)
{
    vec3 data = vec3(0.0);
#ifdef HAS_OBJECTS
    Nearest hit = nearestHit(eye.ray);
    bool missed = hit.object < 0;
    hit.t = missed ? 0.0 : hit.t;
    hit.object = max(hit.object, 0);
#ifdef HAS_OBJECT_VIEW
    data = objectColour(hit.object);
#endif
#ifdef HAS_DEPTH_VIEW
    // Metres, and how often: the mean is that of the samples that meet something.
    data = vec3(hit.t, 1.0, 0.0);
#endif
#ifdef HAS_SURFACE_VIEW
    int kind = kindOf(hit.object);
    Shape shape = shapeOf(hit.object);
    vec3 outward = outwardNormal(eye.ray, hit, kind, shape);
#ifdef HAS_NORMAL_VIEW
    data = 0.5 + 0.5 * (hit.inside ? -outward : outward);
#endif
#ifdef HAS_UV_VIEW
    vec3 position = hitPosition(eye.ray, hit, kind, shape, outward);
    Coordinates coordinates = coordinatesOf(position, outward, kind, shape, materialOf(hit.object));
    data = vec3(fract(coordinates.picture), 0.0);
#endif
#endif
    data = missed ? vec3(0.0) : data;
#endif
    return vec4(data, 1.0);
}
