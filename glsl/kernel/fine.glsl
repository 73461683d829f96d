// Numbers and vectors of twice the digits: the sum of a float and of what rounding it lost.

// x + y of a number: vec2. The same of a vector:
struct FineVector {
    vec3 high;
    vec3 low;
};

FineVector fineVector(vec3 high, vec3 low)
{
    FineVector result;
    result.high = high;
    result.low = low;
    return result;
}

// a - (high + low), of which a - high is without loss.
FineVector fineDifference(vec3 a, vec3 high, vec3 low)
{
    vec2 x = twoSum(a.x, -high.x);
    vec2 y = twoSum(a.y, -high.y);
    vec2 z = twoSum(a.z, -high.z);
    return fineVector(vec3(x.x, y.x, z.x), vec3(x.y, y.y, z.y) - low);
}

// The sum of fine numbers; what is lost is of the order of the lows' rounding.
vec2 fineSum(vec2 a, vec2 b)
{
    vec2 sum = twoSum(a.x, b.x);
    return vec2(sum.x, sum.y + (a.y + b.y));
}

vec2 fineProduct(vec2 a, vec2 b)
{
    vec2 product = twoProduct(a.x, b.x);
    return vec2(product.x, product.y + (a.x * b.y + a.y * b.x));
}

// a . b. Ogita, Rump, Oishi, "Accurate sum and dot product", SIAM Journal on Scientific Computing 26 (2005), Dot2.
vec2 fineDot(FineVector a, FineVector b)
{
    vec2 sum = fineSum(fineSum(twoProduct(a.high.x, b.high.x), twoProduct(a.high.y, b.high.y)),
                       twoProduct(a.high.z, b.high.z));
    return vec2(sum.x, sum.y + (dot(a.high, b.low) + dot(a.low, b.high)));
}

// a b - c d, the difference of two products that may be nearly alike.
vec2 productDifference(float a, float b, float c, float d)
{
    vec2 second = twoProduct(c, d);
    return fineSum(twoProduct(a, b), -second);
}

// a x b. The cross product of b and a is its exact negative.
FineVector fineCross(FineVector a, FineVector b)
{
    vec2 x = productDifference(a.high.y, b.high.z, a.high.z, b.high.y);
    vec2 y = productDifference(a.high.z, b.high.x, a.high.x, b.high.z);
    vec2 z = productDifference(a.high.x, b.high.y, a.high.y, b.high.x);
    vec3 rest = cross(a.high, b.low) - cross(b.high, a.low);
    // Where the products are alike the rest is all that there is.
    x = twoSum(x.x, x.y + rest.x);
    y = twoSum(y.x, y.y + rest.y);
    z = twoSum(z.x, z.y + rest.z);
    return fineVector(vec3(x.x, y.x, z.x), vec3(x.y, y.y, z.y));
}

// a + t b, to which t b adds without loss.
FineVector fineStep(FineVector a, float t, FineVector b)
{
    vec2 x = fineSum(vec2(a.high.x, a.low.x), twoProduct(t, b.high.x));
    vec2 y = fineSum(vec2(a.high.y, a.low.y), twoProduct(t, b.high.y));
    vec2 z = fineSum(vec2(a.high.z, a.low.z), twoProduct(t, b.high.z));
    // Where both are alike the rest is all that there is.
    x = twoSum(x.x, x.y + t * b.low.x);
    y = twoSum(y.x, y.y + t * b.low.y);
    z = twoSum(z.x, z.y + t * b.low.z);
    return fineVector(vec3(x.x, y.x, z.x), vec3(x.y, y.y, z.y));
}
