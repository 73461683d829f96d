#include "command/progress.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace dioptre
{

std::function<void(double)> terminalProgress()
{
    if (isatty(STDERR_FILENO) == 0)
        return {};
    const auto start = std::chrono::steady_clock::now();
    return [start](double done) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        if (elapsed.count() < 1.0)
            return;
        const double left_s = elapsed.count() * (1.0 - done) / done;
        fmt::print(stderr, "\r{:3.0f} %, {:.0f} s left ", 100.0 * done, left_s);
        if (done >= 1.0)
            fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    };
}

std::function<void(double)> terminalProgressOfFrames(std::size_t frames)
{
    if (isatty(STDERR_FILENO) == 0)
        return {};
    const auto start = std::chrono::steady_clock::now();
    return [start, frames](double done) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        const auto all = static_cast<double>(frames);
        if (elapsed.count() < 1.0 || done <= 0.0)
            return;
        fmt::print(stderr, "\r\033[K{:.0f} of {} frames, {:.0f} s left ", std::floor(done), frames,
                   elapsed.count() * (all - done) / done);
        if (done >= all)
            fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    };
}

} // namespace dioptre
