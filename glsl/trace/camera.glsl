// From a pixel and a sample's index to the ray that leaves the eye.

// The sample's place in its pixel, -0.5..0.5: the centre first, then pairs o, -o of the R2 sequence (M. Roberts, "The
// unreasonable effectiveness of quasirandom sequences", 2018), the same for every pixel.
vec2 sampleOffset(int index)
{
    float pair = floor(0.5 * float(index + 1));
    vec2 offset = fract(0.5 + pair * vec2(0.7548776662466927, 0.5698402909980532)) - 0.5;
    bool mirrored = float(index) == 2.0 * pair;
    return mirrored ? -offset : offset;
}

// The eye's path through a point of the picture, in pixels from its lower left corner. Square pixels, centred view.
Path eyePath(vec2 point_px)
{
    vec2 view = (2.0 * point_px - u_resolution) / u_resolution.y;
    Path path;
    path.ray.origin = u_camera.eye.xyz;
    path.ray.direction =
        normalize(u_camera.forward.xyz + view.x * u_camera.right.xyz + view.y * u_camera.up.xyz);
    path.ray.from = -1;
    path.weight = vec3(1.0);
#ifdef HAS_PICTURES
    path.travelled = 0.0;
#endif
#ifdef HAS_ABSORPTION
    path.medium = int(u_camera.eye.w);
#endif
#ifdef HAS_TRUST
    path.blur = blurOf(0.0, SINGLE_ROUNDOFF);
#endif
#ifdef HAS_DEPTH_LIMIT
    path.bounces = 0;
#endif
    return path;
}
