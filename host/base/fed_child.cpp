#include "base/fed_child.h"

#include "base/interruption.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

// Gives 0 where it cannot be started. It hears SIGPIPE as usual, which we may ignore.
pid_t spawn(std::vector<std::string> command, int input, int printed)
{
    std::vector<char*> arguments;
    for (std::string& text : command)
        arguments.push_back(text.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, printed, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, printed, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    pid_t child = 0;
    const int fault =
        ::posix_spawnp(&child, command.front().c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return fault == 0 ? child : 0;
}

std::string contentsOf(int file)
{
    std::string text;
    std::array<char, 4096> buffer{};
    ::lseek(file, 0, SEEK_SET);
    for (ssize_t got = 0; (got = ::read(file, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(got));
    return text;
}

int waitFor(pid_t child)
{
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return W_EXITCODE(1, 0);
    return status;
}

} // namespace

std::unique_ptr<FedChild> FedChild::start(const std::vector<std::string>& command)
{
    // Whoever started us may have had it ignored: then no child leaves a status behind.
    ::signal(SIGCHLD, SIG_DFL);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return nullptr;
    const int printed = ::memfd_create("printed", MFD_CLOEXEC);
    const pid_t child = printed >= 0 ? spawn(command, ends[0], printed) : 0;
    ::close(ends[0]);
    if (child != 0)
        return std::unique_ptr<FedChild>(new FedChild(child, ends[1], printed));
    ::close(ends[1]);
    if (printed >= 0)
        ::close(printed);
    return nullptr;
}

FedChild::FedChild(int process, int input, int printed)
    : process_(process), input_(input), printed_(printed), pipeHandler_(::signal(SIGPIPE, SIG_IGN))
{
}

FedChild::~FedChild()
{
    if (process_ != 0) {
        ::kill(-process_, SIGKILL); // its children too
        waitFor(process_);
    }
    closeInput();
    ::close(printed_);
    ::signal(SIGPIPE, pipeHandler_);
}

void FedChild::closeInput()
{
    if (input_ >= 0)
        ::close(input_);
    input_ = -1;
}

bool FedChild::write(std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty()) {
        const ssize_t taken = ::write(input_, bytes.data(), bytes.size());
        if (taken >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(taken));
        else if (errno != EINTR)
            return false;
        Interruption::check();
    }
    return true;
}

bool FedChild::hasEnded() const
{
    return process_ == 0 || dioptre::hasEnded(process_);
}

void FedChild::interrupt() const
{
    if (process_ != 0)
        ::kill(-process_, SIGTERM);
}

ChildOutcome FedChild::finish()
{
    closeInput();
    const int status = waitFor(process_);
    process_ = 0;
    ChildOutcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    outcome.error = contentsOf(printed_);
    return outcome;
}

} // namespace dioptre
