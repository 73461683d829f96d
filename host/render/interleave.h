// Frames of several drawings, timed in turn.
#pragma once

#include "render/drawing.h"
#include "render/frame_clock.h"

#include <functional>
#include <limits>
#include <vector>

namespace dioptre
{

struct Rounds {
    std::size_t warmUp = 5; // first, and not counted
    std::size_t least = 6;  // counted, whatever they take
    std::size_t most = 30;
    double budget_ms = std::numeric_limits<double>::infinity(); // no further pair of rounds after that
};

// Each drawing's frame times in milliseconds, round by round: every one is drawn once in a round, in ABBA
// order. `progress` is told the share done; it may be empty.
std::vector<std::vector<double>> timeInterleaved(const std::vector<Drawing*>& drawings, FrameClock& clock,
                                                 const Rounds& rounds,
                                                 const std::function<void(double)>& progress);

} // namespace dioptre
