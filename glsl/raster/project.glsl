// From places in the scene to the picture, the same view as eyePath()'s: a sample's offset moves the whole picture, and no far
// plane cuts it.
vec4 clipFromScene(vec4 place)
{
    vec3 offset = place.xyz - place.w * u_camera.eye.xyz;
    float ahead = dot(offset, u_camera.forward.xyz);
    vec3 right = u_camera.right.xyz;
    vec3 up = u_camera.up.xyz;
    vec2 view = vec2(dot(offset, right) / dot(right, right), dot(offset, up) / dot(up, up));
    vec2 moved = 2.0 * sampleOffset(u_sample_first) / u_resolution;
    vec2 clip = view * vec2(u_resolution.y / u_resolution.x, 1.0) - moved * ahead;
    return vec4(clip, ahead - 2.0 * u_near_m * place.w, ahead);
}
