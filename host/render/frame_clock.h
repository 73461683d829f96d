// The time of a frame, by the clock that tells the truth on the driver at hand.
#pragma once

#include "gl/context.h"
#include "gl/object.h"

#include <functional>
#include <string>

namespace dioptre
{

enum class ClockKind {
    finish,     // glFinish and the monotonic clock
    timerQuery, // GL_TIME_ELAPSED: the device's own time, without the host's
};

// Timer queries lie on software drivers (2 ms for a draw of 75 ms on llvmpipe), and a driver may have none.
ClockKind clockFor(const ContextInfo& context);

// "glFinish and the monotonic clock", "timer queries".
std::string nameOf(ClockKind kind);

// On the current context.
class FrameClock
{
public:
    explicit FrameClock(ClockKind kind);

    // Milliseconds from an idle device to the end of all that `submit` asks of it.
    double time_ms(const std::function<void()>& submit);

private:
    ClockKind kind_;
    Query query_; // empty for other kinds
};

} // namespace dioptre
