// --exposure and --curve, as several commands take them.
#pragma once

#include "base/tone_curve.h"

#include <optional>
#include <string>

namespace dioptre
{

// `usual` with what was asked for in its place. `curve`: a word of toneCurves, "" for none asked for.
Display displayAsked(const Display& usual, const std::optional<double>& exposure, const std::string& curve);

} // namespace dioptre
