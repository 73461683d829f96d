// Sphere and cylinder with compensated arithmetic: for shapes that are small, thin or far against a ray's way to them. The
// direction may have any length; `f` is the ray's origin less the centre or the base.

// Where a line is inside a round solid, with what the normals need: in the frame of the centre, or of the axis' nearest point,
// it enters at foot - half_chord and leaves at foot + half_chord.
struct Chord {
    Span span;
    vec3 foot;
    vec3 half_chord;
};

// The outward normal where the line leaves or enters.
vec3 chordNormal(Chord chord, bool leaves, float radius)
{
    return (leaves ? chord.foot + chord.half_chord : chord.foot - chord.half_chord) / radius;
}

// Both roots from the middle, half their difference and their product, without a difference of nearly equal numbers.
Span spanOfRoots(bool found, float middle, float halfLength, float product)
{
    float larger = middle >= 0.0 ? middle + halfLength : middle - halfLength;
    float smaller = larger == 0.0 ? 0.0 : product / larger;
    Span span;
    span.found = found;
    span.near = min(smaller, larger);
    span.far = max(smaller, larger);
    return span;
}

// The line's point nearest to the centre is taken twice: the second step brings it from the accuracy of |f| to that of the
// radius.
Chord fineSphereChord(FineVector f, FineVector direction, float radius)
{
    vec3 d = direction.high;
    float dd = dot(d, d);
    float first = -dot(f.high, d) / dd;
    FineVector nearby = fineStep(f, first, direction);
    float second = -dot(nearby.high, d) / dd;
    FineVector foot = fineStep(nearby, second, direction);
    vec2 square = twoProduct(radius, radius);
    vec2 reach = fineSum(square, -fineDot(foot, foot));
    float halfLength = sqrt(max(reach.x + reach.y, 0.0) / dd);
    vec2 power = fineSum(fineDot(f, f), -square); // of the origin with respect to the sphere
    Chord chord;
    chord.span = spanOfRoots(reach.x + reach.y >= 0.0 && radius > 0.0, first + second, halfLength,
                             (power.x + power.y) / dd);
    chord.foot = foot.high;
    chord.half_chord = halfLength * d;
    return chord;
}

// The infinite cylinder about the line along `axis`, a vector of any length. With m = d x axis and g = f x axis the distance
// of line and axis is |f.m| / |m|, and the roots are those of |g + t m|^2 = R^2 |axis|^2.
Chord fineSideChord(FineVector f, FineVector direction, FineVector axis, float radius)
{
    FineVector m = fineCross(direction, axis);
    FineVector g = fineCross(f, axis);
    vec2 mm = fineDot(m, m);
    vec2 aa = fineDot(axis, axis);
    vec2 fm = fineDot(f, m);
    vec2 gm = fineDot(g, m);
    vec2 square = twoProduct(radius, radius);
    bool parallel = mm.x == 0.0;
    float perMm = 1.0 / (parallel ? 1.0 : mm.x);
    vec2 reach = fineSum(fineProduct(square, mm), -fineProduct(fm, fm)); // times |m|^2
    vec2 power = fineSum(fineDot(g, g), -fineProduct(aa, square));       // of the origin, times |axis|^2
    float outside = power.x + power.y;
    float halfLength = sqrt(max(reach.x + reach.y, 0.0)) * sqrt(aa.x) * perMm;
    Chord chord;
    chord.span = spanOfRoots(reach.x + reach.y >= 0.0, -(gm.x + gm.y) * perMm, halfLength, outside * perMm);
    chord.span.found = radius > 0.0 && aa.x > 0.0 && (parallel ? outside <= 0.0 : chord.span.found);
    chord.span.near = parallel ? -FAR_AWAY : chord.span.near;
    chord.span.far = parallel ? FAR_AWAY : chord.span.far;
    chord.foot = (fm.x + fm.y) * perMm * m.high;
    chord.half_chord = halfLength / (aa.x > 0.0 ? aa.x : 1.0) * cross(axis.high, m.high);
    return chord;
}

// The stretch of the line between the ends of a cylinder, whose height is the axis' length.
Span fineSlabSpan(FineVector f, FineVector direction, FineVector axis)
{
    vec2 start = fineDot(f, axis);
    vec2 rest = fineSum(fineDot(axis, axis), -start);
    vec2 slope = fineDot(direction, axis);
    float rise = slope.x + slope.y;
    bool parallel = rise == 0.0;
    float perRise = 1.0 / (parallel ? 1.0 : rise);
    float toBase = -(start.x + start.y) * perRise;
    float toTop = (rest.x + rest.y) * perRise;
    Span span;
    span.found = !parallel || (start.x + start.y >= 0.0 && rest.x + rest.y >= 0.0);
    span.near = parallel ? -FAR_AWAY : min(toBase, toTop);
    span.far = parallel ? FAR_AWAY : max(toBase, toTop);
    return span;
}
