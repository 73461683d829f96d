#include "render/frame_clock.h"

#include "base/clock.h"

namespace dioptre
{

ClockKind clockFor(const ContextInfo& context)
{
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    return context.software || bits == 0 ? ClockKind::finish : ClockKind::timerQuery;
}

std::string nameOf(ClockKind kind)
{
    return kind == ClockKind::finish ? "glFinish and the monotonic clock" : "timer queries";
}

FrameClock::FrameClock(ClockKind kind) : kind_(kind)
{
    if (kind == ClockKind::timerQuery) {
        GLuint name = 0;
        glGenQueries(1, &name);
        query_ = Query(name);
    }
}

double FrameClock::time_ms(const std::function<void()>& submit)
{
    glFinish();
    if (kind_ == ClockKind::timerQuery) {
        glBeginQuery(GL_TIME_ELAPSED, query_.name());
        submit();
        glEndQuery(GL_TIME_ELAPSED);
        GLuint64 elapsed_ns = 0;
        glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &elapsed_ns); // waits for it
        return static_cast<double>(elapsed_ns) * 1e-6;
    }
    Stopwatch watch;
    submit();
    glFinish();
    return watch.lap_ms();
}

} // namespace dioptre
