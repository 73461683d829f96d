// Latitude-longitude maps, by the arctangent alone: acos and asin lose half the digits near the poles.

// atan(y, x): the angle of a point, -PI to PI. Undefined where both are 0, as it is there.
float arctangent(float y, float x)
{
#ifdef HAS_ARCTANGENT_POLYNOMIAL
    // Of the odd polynomials of degree 13 the one whose largest error over ratios 0..1 is least (Remez's exchange algorithm in
    // double): 2.5e-7 rad.
    float ratio = min(abs(x), abs(y)) / max(abs(x), abs(y));
    float square = ratio * ratio;
    float angle = 0.00681179343;
    angle = angle * square - 0.0336042196;
    angle = angle * square + 0.0796236694;
    angle = angle * square - 0.132333428;
    angle = angle * square + 0.198078156;
    angle = angle * square - 0.333173692;
    angle = angle * square + 0.999996126;
    angle = angle * ratio;
    // Back from the octant between the x axis and the diagonal.
    angle = abs(y) > abs(x) ? 0.5 * PI - angle : angle;
    angle = x < 0.0 ? PI - angle : angle;
    return y < 0.0 ? -angle : angle;
#else
    return atan(y, x);
#endif
}

// u = 0.5 + atan(x, z) / 2 pi, v = 0.5 + latitude / pi for a direction of any length; u = 0.5 at the poles.
vec2 latLong(vec3 direction)
{
    float ring = length(direction.xz);
    float longitude = ring > 0.0 ? arctangent(direction.x, direction.z) : 0.0;
    return vec2(0.5 + longitude / (2.0 * PI), 0.5 + arctangent(direction.y, ring) / PI);
}
