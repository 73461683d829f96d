#include "render/interleave.h"

#include "base/clock.h"
#include "base/statistics.h"

#include <algorithm>

namespace dioptre
{

std::vector<std::vector<double>> timeInterleaved(const std::vector<Drawing*>& drawings, FrameClock& clock,
                                                 const Rounds& rounds,
                                                 const std::function<void(double)>& progress)
{
    std::vector<std::vector<double>> times_ms(drawings.size());
    const auto all = static_cast<double>(rounds.warmUp + rounds.most);
    Stopwatch watch;
    double elapsed_ms = 0.0;
    for (std::size_t round = 0; round < rounds.warmUp + rounds.most; ++round) {
        const std::size_t counted = round - std::min(round, rounds.warmUp);
        if (counted >= rounds.least && counted % 2 == 0 && elapsed_ms > rounds.budget_ms)
            break;
        for (const std::size_t i : roundOrder(drawings.size(), counted)) {
            const double frame_ms = clock.time_ms([&] { drawings[i]->submit(); });
            if (round >= rounds.warmUp)
                times_ms[i].push_back(frame_ms);
        }
        elapsed_ms += watch.lap_ms();
        const double share = std::max(static_cast<double>(round + 1) / all, elapsed_ms / rounds.budget_ms);
        if (progress)
            progress(std::min(0.99, share)); // the whole is told once
    }
    if (progress)
        progress(1.0);
    return times_ms;
}

} // namespace dioptre
