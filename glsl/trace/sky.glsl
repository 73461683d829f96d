// What a ray sees that leaves the scene.

vec3 skyRadiance(vec3 direction)
{
    vec3 radiance = u_sky.colour.xyz;
#ifdef HAS_SKY_GRADIENT
    radiance = mix(u_sky.horizon.xyz, direction.y > 0.0 ? u_sky.zenith.xyz : u_sky.colour.xyz, abs(direction.y));
#endif
#ifdef HAS_SKY_PICTURE
    // The picture's middle lies along -z; u grows to the right.
    float c = u_sky.turn.x;
    float s = u_sky.turn.y;
    vec3 turned = vec3(c * direction.x - s * direction.z, direction.y, s * direction.x + c * direction.z);
    vec2 uv = latLong(vec3(u_sky.turn.z * turned.x, turned.y, -turned.z));
    radiance = radiance * textureLod(u_sky_picture, uv, 0.0).xyz;
#endif
    return radiance;
}
