#include "gl/attempt.h"

#include "base/clock.h"
#include "base/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

constexpr unsigned patience_s = 60; // a context that takes longer never comes

// What a child says, one line each: fault, mend, absent; where there is no fault also renderer, version, GLSL
// version, software, milliseconds.
std::string attemptInChild(const std::string& backend)
{
    Stopwatch watch;
    std::vector<BackendAttempt> attempts;
    try {
        const auto context = makeContext(backend, &attempts);
        const double start_ms = watch.lap_ms();
        const ContextInfo& info = context->info();
        return fmt::format("\n\n0\n{}\n{}\n{}\n{:d}\n{}\n", info.renderer, info.version, info.glslVersion,
                           info.software, start_ms);
    } catch (const std::exception& error) {
        const BackendAttempt last =
            attempts.empty() ? BackendAttempt{backend, error.what()} : attempts.back();
        return fmt::format("{}\n{}\n{:d}\n", last.outcome, last.mend, last.absent);
    }
}

std::string readAll(int descriptor)
{
    std::string text;
    std::array<char, 512> bytes{};
    for (ssize_t count = 0; (count = ::read(descriptor, bytes.data(), bytes.size())) > 0;)
        text.append(bytes.data(), static_cast<std::size_t>(count));
    return text;
}

// How a child ended that did not say what came of it.
std::string endOf(int status)
{
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
        return fmt::format("the driver does not answer within {} s", patience_s);
    if (WIFSIGNALED(status))
        return fmt::format("the driver crashes ({})", ::strsignal(WTERMSIG(status)));
    return fmt::format("the driver ends the process (exit code {})", WEXITSTATUS(status));
}

BackendReport reportFrom(const std::string& backend, const std::string& said)
{
    BackendReport report;
    report.info.backend = backend;
    std::istringstream lines(said);
    std::string absent, software, start_ms;
    std::getline(lines, report.fault);
    std::getline(lines, report.mend);
    std::getline(lines, absent);
    std::getline(lines, report.info.renderer);
    std::getline(lines, report.info.version);
    std::getline(lines, report.info.glslVersion);
    std::getline(lines, software);
    std::getline(lines, start_ms);
    report.absent = absent == "1";
    report.info.software = software == "1";
    report.start_ms = start_ms.empty() ? 0.0 : std::stod(start_ms);
    return report;
}

} // namespace

BackendReport tryBackend(const std::string& backend)
{
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0)
        fail(ExitCode::retry, fmt::format("there are no more pipes ({})", std::strerror(errno)), "try again");
    const pid_t child = ::fork();
    if (child < 0)
        fail(ExitCode::retry, fmt::format("there are no more processes ({})", std::strerror(errno)),
             "try again");
    if (child == 0) {
        ::alarm(patience_s);
        const std::string said = attemptInChild(backend);
        const ssize_t written = ::write(ends[1], said.data(), said.size());
        ::_exit(written == static_cast<ssize_t>(said.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    const std::string said = readAll(ends[0]);
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!said.empty())
        return reportFrom(backend, said);
    BackendReport report;
    report.info.backend = backend;
    report.fault = endOf(status);
    report.endedProcess = true;
    return report;
}

} // namespace dioptre
