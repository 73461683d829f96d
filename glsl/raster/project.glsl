// From places in the scene to the cell of the picture that is drawn, in the same view as eyePath()'s: a sample's offset moves
// the whole picture. No plane cuts it, near or far: depth is nearness(). u_tile_origin_px is the cell's lower left corner.
vec4 clipFromScene(vec4 place)
{
    vec3 offset = place.xyz - place.w * u_camera.eye.xyz;
    float ahead = dot(offset, u_camera.forward.xyz);
    vec3 right = u_camera.right.xyz;
    vec3 up = u_camera.up.xyz;
    vec2 view = vec2(dot(offset, right) / dot(right, right), dot(offset, up) / dot(up, up));
    // eyePath()'s view of a point: (2 point - resolution) / resolution.y.
    vec2 twice_px = view * u_resolution.y + ahead * (u_resolution - 2.0 * (sampleOffset(u_sample_first) + u_tile_origin_px));
    // At the picture's right and upper edges a cell ends with it.
    vec2 cell_px = min(vec2(float(CELL_PX)), u_resolution - u_tile_origin_px);
    return vec4(twice_px / cell_px - ahead, 0.0, ahead);
}
