// Latitude-longitude maps, by atan alone: acos and asin lose half the digits near the poles.

// u = 0.5 + atan(x, z) / 2 pi, v = 0.5 + latitude / pi for a direction of any length; u = 0.5 at the poles.
vec2 latLong(vec3 direction)
{
    float ring = length(direction.xz);
    float longitude = ring > 0.0 ? atan(direction.x, direction.z) : 0.0;
    return vec2(0.5 + longitude / (2.0 * PI), 0.5 + atan(direction.y, ring) / PI);
}
