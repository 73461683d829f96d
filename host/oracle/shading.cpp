#include "oracle/shading.h"

#include "oracle/quad.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

Quad pi()
{
    return atan2q(0, -1);
}

// IEC 61966-2-1.
Quad srgbEncoded(Quad linear)
{
    if (linear <= static_cast<Quad>(31308) / 10000000)
        return linear * 1292 / 100;
    return powq(linear, static_cast<Quad>(10) / 24) * 1055 / 1000 - static_cast<Quad>(55) / 1000;
}

// See ToneCurve.
Quad curveAt(ToneCurve curve, Quad x)
{
    switch (curve) {
    case ToneCurve::reinhard:
        return x / (1 + x);
    case ToneCurve::filmic:
        return x * (251 * x + 3) / (x * (243 * x + 59) + 14);
    case ToneCurve::none:
        break;
    }
    return x;
}

} // namespace

double microfacetDensity(const glm::dvec3& normal, const glm::dvec3& half, double alpha)
{
    const QuadVec n = quadFrom(normal);
    const QuadVec h = quadFrom(half);
    if (dot(n, h) <= 0)
        return 0.0;
    const Quad angle_rad = angleBetween_rad(n, h);
    const Quad cosine = cosq(angle_rad);
    const Quad slope = tanq(angle_rad) / static_cast<Quad>(alpha);
    const Quad root = cosine * cosine * static_cast<Quad>(alpha) * (1 + slope * slope);
    return static_cast<double>(1 / (pi() * root * root));
}

double cosineLobe(const glm::dvec3& a, const glm::dvec3& b, double exponent)
{
    const Quad cosine = dot(quadFrom(a), quadFrom(b));
    if (cosine <= 0)
        return 0.0;
    return static_cast<double>(powq(cosq(angleBetween_rad(quadFrom(a), quadFrom(b))), exponent));
}

SpotCone spotCone(const glm::dvec3& axis, const glm::dvec3& fromLight, double cutoff_rad, double exponent)
{
    const Quad angle_rad = angleBetween_rad(quadFrom(axis), quadFrom(fromLight));
    if (angle_rad > static_cast<Quad>(cutoff_rad))
        return {};
    return {true, exponent == 0.0 ? 1.0 : cosineLobe(axis, fromLight, exponent)};
}

double attenuationAt(const glm::dvec3& coefficients, double distance_m, double nearest_m)
{
    const Quad d = std::max(distance_m, nearest_m);
    const QuadVec k = quadFrom(coefficients);
    return static_cast<double>(1 / (k.x + k.y * d + k.z * d * d));
}

glm::dvec2 latLongPlace(const glm::dvec3& direction)
{
    const QuadVec d = quadFrom(direction);
    const bool pole = direction.x == 0.0 && direction.z == 0.0;
    const Quad longitude_rad = pole ? 0 : atan2q(d.x, d.z);
    const QuadVec up{0, 1, 0};
    const Quad latitude_rad = pi() / 2 - angleBetween_rad(up, d);
    const Quad half = static_cast<Quad>(1) / 2;
    return {static_cast<double>(half + longitude_rad / (2 * pi())),
            static_cast<double>(half + latitude_rad / pi())};
}

double displayValue(double radiance, const Display& display)
{
    if (std::isnan(radiance))
        return 0.0;
    // The largest double's square is far from quad's largest: no curve is inf / inf.
    const Quad bounded = std::clamp(radiance, 0.0, std::numeric_limits<double>::max());
    const Quad exposed = bounded * powq(2, display.exposure);
    const Quad toned = curveAt(display.curve, exposed);
    const Quad shown = toned < 1 ? toned : 1;
    if (!display.gamma)
        return static_cast<double>(srgbEncoded(shown));
    return static_cast<double>(shown > 0 ? powq(shown, 1 / static_cast<Quad>(*display.gamma)) : 0);
}

} // namespace dioptre
