#include "metric/flip_colour.h"

#include <cmath>

namespace dioptre
{
namespace
{

glm::dvec3 xyzOf(double x, double y) // chromaticity, at Y = 1
{
    return {x / y, 1.0, (1.0 - x - y) / y};
}

// The amounts of the primaries are such that together they are white.
glm::dmat3 makeWhiteRelativeXyz()
{
    const glm::dvec3 white = xyzOf(0.31271, 0.32902);
    const glm::dmat3 primaries(xyzOf(0.64, 0.33), xyzOf(0.30, 0.60), xyzOf(0.15, 0.06));
    const glm::dvec3 amounts = glm::inverse(primaries) * white;
    glm::dmat3 matrix(primaries[0] * amounts[0], primaries[1] * amounts[1], primaries[2] * amounts[2]);
    for (int column = 0; column < 3; ++column)
        matrix[column] /= white;
    return matrix;
}

const glm::dmat3& xyzFromRgb()
{
    static const glm::dmat3 matrix = makeWhiteRelativeXyz();
    return matrix;
}

const glm::dmat3& rgbFromXyz()
{
    static const glm::dmat3 matrix = glm::inverse(xyzFromRgb());
    return matrix;
}

// CIE 15:2004, equation 8.4: a cube root that goes on as a line near black.
double labCurve(double t)
{
    constexpr double delta = 6.0 / 29.0;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
}

} // namespace

glm::dvec3 whiteRelativeXyz(const glm::dvec3& linearRgb)
{
    return xyzFromRgb() * linearRgb;
}

glm::dvec3 opponentFromRgb(const glm::dvec3& linearRgb)
{
    const glm::dvec3 xyz = whiteRelativeXyz(linearRgb);
    return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 rgbFromOpponent(const glm::dvec3& opponent)
{
    const double y = (opponent.x + 16.0) / 116.0;
    return rgbFromXyz() * glm::dvec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0);
}

glm::dvec3 huntLabFromRgb(const glm::dvec3& linearRgb)
{
    const glm::dvec3 xyz = whiteRelativeXyz(linearRgb);
    const double x = labCurve(xyz.x), y = labCurve(xyz.y), z = labCurve(xyz.z);
    const double lightness = 116.0 * y - 16.0, hunt = 0.01 * lightness;
    return {lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)};
}

double hyab(const glm::dvec3& some, const glm::dvec3& other)
{
    return std::abs(some.x - other.x) + std::hypot(some.y - other.y, some.z - other.z);
}

double colourDifference(const glm::dvec3& some, const glm::dvec3& other)
{
    constexpr double exponent = 0.7, knee = 0.4, atKnee = 0.95; // q_c, p_c, p_t
    static const double largest =
        std::pow(hyab(huntLabFromRgb({0.0, 1.0, 0.0}), huntLabFromRgb({0.0, 0.0, 1.0})), exponent);
    const double difference = std::pow(hyab(huntLabFromRgb(some), huntLabFromRgb(other)), exponent) / largest;
    if (difference < knee)
        return difference * atKnee / knee;
    return atKnee + (difference - knee) / (1.0 - knee) * (1.0 - atKnee);
}

} // namespace dioptre
