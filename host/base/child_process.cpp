#include "base/child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

// Both ends close when the child is done with them, whatever happens here.
struct Pipe {
    std::array<int, 2> ends{-1, -1}; // to read, to write

    Pipe()
    {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            ends = {-1, -1};
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe()
    {
        close(0);
        close(1);
    }
    void close(std::size_t end)
    {
        if (ends[end] >= 0)
            ::close(ends[end]);
        ends[end] = -1;
    }
};

std::vector<std::string> mergedEnvironment(const std::map<std::string, std::string>& changes)
{
    std::vector<std::string> merged;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        if (!changes.contains(text.substr(0, text.find('='))))
            merged.push_back(text);
    }
    for (const auto& [name, value] : changes)
        merged.push_back(name + "=" + value);
    return merged;
}

// The null-ended array that exec wants; it points into `texts`.
std::vector<char*> pointersTo(std::vector<std::string>& texts)
{
    std::vector<char*> pointers;
    for (std::string& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

// Starts the program with its output in our pipes. Gives 0 where it cannot.
pid_t start(std::vector<std::string> command, const std::map<std::string, std::string>& changes,
            const Pipe& out, const Pipe& error)
{
    std::vector<std::string> environment = mergedEnvironment(changes);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, error.ends[1], STDERR_FILENO);
    pid_t child = 0;
    const int fault = ::posix_spawnp(&child, command.front().c_str(), &actions, nullptr,
                                     pointersTo(command).data(), pointersTo(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    return fault == 0 ? child : 0;
}

// Reads both pipes as they fill: a child that waits for one of them to be read never ends.
void drain(Pipe& out, Pipe& error, ChildOutcome& outcome)
{
    std::array<char, 4096> buffer{};
    while (out.ends[0] >= 0 || error.ends[0] >= 0) {
        std::array<pollfd, 2> polled{{{out.ends[0], POLLIN, 0}, {error.ends[0], POLLIN, 0}}};
        if (::poll(polled.data(), polled.size(), -1) < 0 && errno != EINTR)
            return;
        for (std::size_t i = 0; i < polled.size(); ++i) {
            Pipe& source = i == 0 ? out : error;
            if (polled[i].revents == 0)
                continue;
            const ssize_t got = ::read(source.ends[0], buffer.data(), buffer.size());
            if (got > 0)
                (i == 0 ? outcome.out : outcome.error).append(buffer.data(), static_cast<std::size_t>(got));
            else if (got == 0 || errno != EINTR)
                source.close(0);
        }
    }
}

} // namespace

std::optional<ChildOutcome> runChild(const std::vector<std::string>& command,
                                     const std::map<std::string, std::string>& environment)
{
    // Whoever started us may have had it ignored: then no child leaves a status behind.
    ::signal(SIGCHLD, SIG_DFL);
    Pipe out;
    Pipe error;
    const pid_t child = start(command, environment, out, error);
    if (child == 0)
        return std::nullopt;
    out.close(1); // so that the reads end when the child does
    error.close(1);
    ChildOutcome outcome;
    drain(out, error, outcome);
    int status = 0;
    rusage used{};
    while (::wait4(child, &status, 0, &used) < 0)
        if (errno != EINTR)
            return std::nullopt;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    outcome.peak_mib = static_cast<double>(used.ru_maxrss) / 1024.0; // Linux counts in KiB
    return outcome;
}

bool hasEnded(pid_t child)
{
    siginfo_t ended{};
    return ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT | WNOHANG) == 0 &&
           ended.si_pid != 0;
}

} // namespace dioptre
