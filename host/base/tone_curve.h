// From radiance to what a display shows: exposure, curve and transfer function.
#pragma once

#include "base/picture.h"

#include <optional>

namespace dioptre
{

// How radiance x becomes 0..1, channel by channel, so that a result never leaves that range and needs no
// clipping that would turn its hue.
enum class ToneCurve {
    none,     // min(x, 1)
    reinhard, // x / (1 + x): Reinhard et al., "Photographic Tone Reproduction", 2002, eq. 3, of each channel
    filmic // Narkowicz's fit of the ACES curve, 2016: x(2.51x + 0.03) / (x(2.43x + 0.59) + 0.14), at most 1
};

// What a display is given. The default is radiance 1 as white.
struct Display {
    double exposure = 0.0; // stops: radiance is multiplied by 2^exposure before the curve
    ToneCurve curve = ToneCurve::none;
    std::optional<double> gamma{}; // x^(1/gamma) in place of the sRGB curve; above 0
};

// 0..1 for every number; NaN stays NaN.
double toned(ToneCurve curve, double radiance);

// The picture after exposure and curve, still linear. Without either it is the very same, numbers beyond 1
// included. Alpha is left alone.
Picture toned(Picture radiance, const Display& display);

} // namespace dioptre
