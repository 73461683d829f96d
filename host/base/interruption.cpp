#include "base/interruption.h"

#include "base/error.h"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <cstring>
#include <unistd.h>

namespace dioptre
{
namespace
{

constexpr std::array<int, 3> watched{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t noted = 0;
std::array<struct sigaction, watched.size()> before{};

} // namespace

Interruption::Interruption()
{
    noted = 0;
    struct sigaction action {
    };
    action.sa_handler = [](int signal) { noted = signal; };
    action.sa_flags = static_cast<int>(SA_RESETHAND); // and no SA_RESTART: a blocked write is to return
    for (std::size_t i = 0; i < watched.size(); ++i) {
        ::sigaction(watched[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN)
            ::sigaction(watched[i], &action, nullptr);
    }
}

Interruption::~Interruption()
{
    for (std::size_t i = 0; i < watched.size(); ++i)
        ::sigaction(watched[i], &before[i], nullptr);
}

int Interruption::signal()
{
    return noted;
}

void Interruption::check()
{
    if (noted != 0)
        fail(ExitCode::retry, fmt::format("stopped by a signal ({})", ::strsignal(noted)), "run it again");
}

int signalDuring(const std::function<void()>& work)
{
    const Interruption interruption;
    try {
        work();
    } catch (const Error&) {
        if (Interruption::signal() == 0)
            throw;
        return Interruption::signal();
    }
    return 0;
}

void endBySignal(int signal)
{
    ::signal(signal, SIG_DFL);
    ::raise(signal);
    ::_exit(128 + signal);
}

} // namespace dioptre
