#include "gl/wait.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/interruption.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>

namespace dioptre
{
namespace
{

constexpr GLuint64 slice_ns = 50'000'000; // between two looks for a signal
constexpr auto grace = std::chrono::seconds(3);

// A context cannot end before its draws do, and an endless draw never does.
void endSoon(const std::string& message, const std::function<void()>& end)
{
    std::thread([message, end] {
        std::this_thread::sleep_for(grace);
        std::fprintf(stderr, "dioptre: %s\n", message.c_str());
        end();
    }).detach();
}

[[noreturn]] void failAsEndless(double limit_s)
{
    try {
        fail(ExitCode::badInput, fmt::format("a draw of few pixels is not done after {:g} s", limit_s),
             "look for a loop that does not end in the shader, or give it longer by --draw-limit");
    } catch (const Error& error) {
        endSoon(error.what(), [code = static_cast<int>(error.code())] { std::_Exit(code); });
        throw;
    }
}

void hearSignals()
{
    try {
        Interruption::check();
    } catch (const Error&) {
        endSoon("stopped by a signal", [signal = Interruption::signal()] { endBySignal(signal); });
        throw;
    }
}

} // namespace

void waitForDevice(double limit_s)
{
    const std::unique_ptr<__GLsync, void (*)(GLsync)> fence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0),
                                                            [](GLsync sync) { glDeleteSync(sync); });
    Stopwatch watch;
    for (double waited_s = 0.0; true; waited_s += watch.lap_ms() / 1000.0) {
        const GLenum outcome = glClientWaitSync(fence.get(), GL_SYNC_FLUSH_COMMANDS_BIT, slice_ns);
        hearSignals();
        if (outcome == GL_ALREADY_SIGNALED || outcome == GL_CONDITION_SATISFIED)
            return;
        if (outcome != GL_TIMEOUT_EXPIRED)
            fail(ExitCode::retry, "the driver lost what it was drawing",
                 "try again, or draw with another --backend");
        if (waited_s > limit_s)
            failAsEndless(limit_s);
    }
}

} // namespace dioptre
