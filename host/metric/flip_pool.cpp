#include "metric/flip.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dioptre
{

PooledFlip pooled(const std::vector<float>& errors, const std::vector<std::uint8_t>& judged)
{
    std::vector<float> sorted;
    sorted.reserve(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (judged[i] != 0)
            sorted.push_back(errors[i]);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (sorted.empty())
        return {none, none, none, none};
    std::ranges::sort(sorted);
    const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
    PooledFlip pooled;
    pooled.mean = sum / static_cast<double>(sorted.size());
    const std::size_t middle = sorted.size() / 2, before = (sorted.size() - 1) / 2;
    pooled.median = 0.5 * (static_cast<double>(sorted[before]) + static_cast<double>(sorted[middle]));
    double part = 0.0;
    for (const float error : sorted) {
        part += static_cast<double>(error);
        pooled.weightedMedian = static_cast<double>(error);
        if (part >= 0.5 * sum)
            break;
    }
    pooled.max = static_cast<double>(sorted.back());
    return pooled;
}

} // namespace dioptre
