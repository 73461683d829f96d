#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace dioptre
{
namespace
{

constexpr int resamples = 2000; // the ends of a 95 % interval then rest on 50 of them each
constexpr double tail = 0.025;

// The interval that holds all but the tails of `statistic`, over rounds drawn with replacement: Efron's
// percentile bootstrap. Its random numbers are always the same.
template <typename Statistic>
void fillInterval(Estimate& estimate, std::size_t rounds, Statistic statistic)
{
    std::mt19937 random(20011);
    std::vector<double> drawn;
    std::vector<std::size_t> picked(rounds);
    for (int i = 0; i < resamples; ++i) {
        for (std::size_t& round : picked)
            round = random() % rounds;
        drawn.push_back(statistic(picked));
    }
    estimate.low = quantile(drawn, tail);
    estimate.high = quantile(drawn, 1.0 - tail);
}

// The middle value, or the mean of the middle two; leaves the values in another order.
double medianWithin(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// `chosen` is room to work in.
double medianOfPicked(std::span<const double> values, const std::vector<std::size_t>& picked,
                      std::vector<double>& chosen)
{
    chosen.clear();
    for (const std::size_t round : picked)
        chosen.push_back(values[round]);
    return medianWithin(chosen);
}

} // namespace

double quantile(std::span<const double> values, double share)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

double median(std::span<const double> values)
{
    std::vector<double> copy(values.begin(), values.end());
    return medianWithin(copy);
}

Estimate medianOf(std::span<const double> values)
{
    Estimate estimate{median(values), 0.0, 0.0, values.size()};
    std::vector<double> room;
    fillInterval(estimate, values.size(),
                 [&](const auto& picked) { return medianOfPicked(values, picked, room); });
    return estimate;
}

Estimate ratioOfMedians(std::span<const double> values, std::span<const double> baseline)
{
    Estimate ratio{median(values) / median(baseline), 0.0, 0.0, values.size()};
    std::vector<double> room;
    fillInterval(ratio, values.size(), [&](const auto& picked) {
        return medianOfPicked(values, picked, room) / medianOfPicked(baseline, picked, room);
    });
    return ratio;
}

double spreadOf(const Estimate& ratio)
{
    return std::max({ratio.high, 1.0 / ratio.low, ratio.value, 1.0 / ratio.value}) - 1.0;
}

bool differs(const Estimate& ratio, double controlSpread)
{
    const bool apartFromOne = ratio.low > 1.0 || ratio.high < 1.0;
    return ratio.rounds >= fewestRounds && apartFromOne &&
           std::max(ratio.value, 1.0 / ratio.value) > 1.0 + controlSpread;
}

std::vector<std::size_t> roundOrder(std::size_t count, std::size_t round)
{
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    if (round % 2 == 1)
        std::reverse(order.begin(), order.end());
    return order;
}

} // namespace dioptre
