// Time between steps, by the monotonic clock.
#pragma once

#include <chrono>

namespace dioptre
{

class Stopwatch
{
public:
    // Milliseconds since the last lap, or since the start.
    double lap_ms()
    {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double, std::milli> lap = now - last_;
        last_ = now;
        return lap.count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace dioptre
