#include "base/tone_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre
{

double toned(ToneCurve curve, double radiance)
{
    if (std::isnan(radiance))
        return radiance;
    // The largest float keeps the quotients of an infinity finite, and they are 1 there as well.
    const double x = std::clamp(radiance, 0.0, static_cast<double>(std::numeric_limits<float>::max()));
    switch (curve) {
    case ToneCurve::reinhard:
        return x / (1.0 + x);
    case ToneCurve::filmic:
        return std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
    case ToneCurve::none:
        break;
    }
    return std::min(x, 1.0);
}

Picture toned(Picture radiance, const Display& display)
{
    if (display.exposure == 0.0 && display.curve == ToneCurve::none)
        return radiance;
    const double scale = std::exp2(display.exposure);
    for (std::size_t i = 0; i < radiance.floats.size(); ++i)
        if (i % 4 < 3)
            radiance.floats[i] =
                static_cast<float>(toned(display.curve, scale * static_cast<double>(radiance.floats[i])));
    return radiance;
}

} // namespace dioptre
