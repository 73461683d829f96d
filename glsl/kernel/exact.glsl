// Sums and products of two floats without loss: the rounded result and the error of its rounding.

// What keeps the compiler from regrouping: `precise` on every intermediate, or the bits of each flipped by a pattern that it
// cannot know to be 0. Of each: where an operand is a constant, compilers regroup what is left unguarded.
#ifdef HAS_PRECISE
#define EXACT precise float
#else
#define EXACT float
#endif
#ifdef HAS_UNIT
uniform float u_one; // 1
#define HELD(x) uintBitsToFloat(floatBitsToUint(x) ^ floatBitsToUint(u_one) ^ 0x3F800000u)
#else
#define HELD(x) (x)
#endif

// x: a + b rounded, y: its error. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
vec2 twoSum(float a, float b)
{
    EXACT sum = HELD(a + b);
    EXACT bRounded = HELD(sum - a);
    EXACT aRounded = HELD(sum - bRounded);
    EXACT error = HELD(a - aRounded) + HELD(b - bRounded);
    return vec2(sum, error);
}

#ifdef HAS_FMA
// x: a b rounded, y: its error, by one rounding of a b - x.
vec2 twoProduct(float a, float b)
{
    EXACT product = a * b;
    EXACT error = fma(a, b, -product);
    return vec2(product, error);
}
#else
// x + y = a, each of half the bits, so that their products are exact. Veltkamp; Dekker, Numerische Mathematik 18 (1971).
vec2 halves(float a)
{
    EXACT scaled = HELD(SPLITTER * a);
    EXACT upper = HELD(scaled - HELD(scaled - a));
    EXACT lower = a - upper;
    return vec2(upper, lower);
}

// x: a b rounded, y: its error. Dekker 1971.
vec2 twoProduct(float a, float b)
{
    vec2 p = halves(a);
    vec2 q = halves(b);
    EXACT product = HELD(a * b);
    EXACT e1 = HELD(HELD(p.x * q.x) - product);
    EXACT e2 = HELD(e1 + HELD(p.x * q.y));
    EXACT e3 = HELD(e2 + HELD(p.y * q.x));
    EXACT error = e3 + HELD(p.y * q.y);
    return vec2(product, error);
}
#endif
