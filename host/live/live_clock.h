// Time as a user plays it: on, held, step by step, or anywhere.
#pragma once

#include <algorithm>
#include <chrono>

namespace dioptre
{

class LiveClock
{
public:
    using Clock = std::chrono::steady_clock;

    explicit LiveClock(double start_s, bool paused) : start_s_(start_s), base_s_(start_s), paused_(paused) {}

    double time_s() const
    {
        return paused_ ? base_s_ : base_s_ + std::chrono::duration<double>(Clock::now() - since_).count();
    }
    bool isPaused() const
    {
        return paused_;
    }
    void pause(bool paused)
    {
        jumpTo(time_s());
        paused_ = paused;
    }
    void jumpTo(double time_s)
    {
        base_s_ = time_s;
        since_ = Clock::now();
    }
    void jumpBy(double seconds)
    {
        jumpTo(time_s() + seconds);
    }
    void restart()
    {
        jumpTo(start_s_);
    }

private:
    double start_s_;
    double base_s_; // at since_, or while paused
    bool paused_;
    Clock::time_point since_ = Clock::now();
};

} // namespace dioptre
