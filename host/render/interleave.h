// Frames of several renderers, timed in turn.
#pragma once

#include "render/frame_clock.h"
#include "render/renderer.h"

#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace dioptre
{

struct Rounds {
    std::size_t warmUp = 5; // first, and not counted
    std::size_t least = 6;  // counted, whatever they take
    std::size_t most = 30;
    double budget_ms = std::numeric_limits<double>::infinity(); // no further pair of rounds after that
};

// Each renderer's frame times in milliseconds, round by round: every renderer draws once in a round, in ABBA
// order. `progress` is told the share done; it may be empty.
std::vector<std::vector<double>> timeInterleaved(const std::vector<std::unique_ptr<Renderer>>& renderers,
                                                 FrameClock& clock, const Rounds& rounds,
                                                 const std::function<void(double)>& progress);

} // namespace dioptre
