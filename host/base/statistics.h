// What repeated timings say: medians with their uncertainty, ratios, and when a difference is none.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace dioptre
{

// The value below which `share` (0..1) of the values lie, linear between neighbours in sorted order. There
// must be at least one value.
double quantile(std::span<const double> values, double share);

double median(std::span<const double> values);

// A figure and the interval that holds its true value in 95 of 100 such measurements.
struct Estimate {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
    std::size_t rounds = 0; // measurements that it rests on
};

// The median, with a percentile bootstrap interval. The same values give the same interval.
Estimate medianOf(std::span<const double> values);

// median(values) / median(baseline). Both were taken in the same rounds, and whole rounds are drawn anew for
// the interval: what disturbed a round disturbed both. They must be of equal length.
Estimate ratioOfMedians(std::span<const double> values, std::span<const double> baseline);

// The largest deviation from 1, as a factor minus 1, that the ratio's interval allows: of a control, which is
// the baseline measured a second time, this is what the measurement cannot tell apart.
double spreadOf(const Estimate& ratio);

// Fewer measurements tell no difference: their interval is next to nothing.
inline constexpr std::size_t fewestRounds = 5;

// Whether a ratio is beyond the control's spread, its own interval apart from 1, and both from enough rounds.
bool differs(const Estimate& ratio, double controlSpread);

// The order in which `count` inputs are measured in a round: forwards and backwards in turn (ABBA), so that a
// machine that grows slower or faster favours none.
std::vector<std::size_t> roundOrder(std::size_t count, std::size_t round);

} // namespace dioptre
