#include "live/trier.h"

#include "live/helper.h"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

// For a driver's compiler: the largest shaders known take some ten seconds.
constexpr double compileLimit_s = 60.0;

// Room for a message, which is a shader's text for the most part: the window does not wait until it is read.
constexpr int pipeBytes = 1 << 20;

using Clock = std::chrono::steady_clock;

} // namespace

struct Trier::Mailbox {
    std::mutex mutex;
    std::optional<TrialReply> reply;
    bool ended = false; // nothing more will come
};

Trier::Trier(std::function<void()> wake) : wake_(std::move(wake))
{
    std::signal(SIGPIPE, SIG_IGN); // a helper that died reads no more
    launch();
}

Trier::~Trier()
{
    end();
}

void Trier::launch()
{
    mailbox_ = std::make_shared<Mailbox>();
    mailbox_->ended = true; // unless a helper starts
    std::array<int, 2> in{}, out{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0)
        return;
    if (::pipe2(out.data(), O_CLOEXEC) != 0) {
        ::close(in[0]);
        ::close(in[1]);
        return;
    }
    ::fcntl(in[1], F_SETPIPE_SZ, pipeBytes);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    std::string program = "/proc/self/exe", word = helperWord;
    const std::array<char*, 3> arguments{program.data(), word.data(), nullptr};
    pid_t process = 0;
    if (::posix_spawn(&process, program.c_str(), &actions, nullptr, arguments.data(), environ) != 0)
        process = 0;
    posix_spawn_file_actions_destroy(&actions);
    ::close(in[0]);
    ::close(out[1]);
    process_ = process;
    input_ = in[1];
    mailbox_->ended = false;
    reader_ = std::thread([mailbox = mailbox_, wake = wake_, output = out[0]] {
        for (bool open = true; open;) {
            auto reply = readTrialReply(output);
            open = reply.has_value();
            {
                const std::lock_guard lock(mailbox->mutex);
                if (open)
                    mailbox->reply = std::move(reply);
                mailbox->ended = !open;
            }
            wake();
        }
        ::close(output);
    });
}

void Trier::end()
{
    if (process_ > 0)
        ::kill(process_, SIGKILL);
    if (input_ >= 0)
        ::close(input_);
    if (reader_.joinable())
        reader_.join();
    if (process_ > 0)
        ::waitpid(process_, nullptr, 0);
    process_ = 0;
    input_ = -1;
}

void Trier::start(long number, std::vector<ProgramTrial> trials, double drawLimit_s)
{
    cancel();
    if (hasEnded()) { // by itself, while it had nothing to do
        end();
        launch();
    }
    asked_ = number;
    askedAt_ = Clock::now();
    limit_s_ = compileLimit_s + drawLimit_s * static_cast<double>(trials.size());
    // What is written and not read is found by take(): the helper is at its end then.
    writeAll(input_, bytesOf(TrialMessage{number, drawLimit_s, std::move(trials)}));
}

void Trier::cancel()
{
    if (asked_ == 0)
        return;
    asked_ = 0;
    end();
    launch();
}

double Trier::busyFor_s() const
{
    return isBusy() ? std::chrono::duration<double>(Clock::now() - askedAt_).count() : 0.0;
}

bool Trier::hasEnded() const
{
    const std::lock_guard lock(mailbox_->mutex);
    return mailbox_->ended;
}

// In words, of one that is no more or is to be no more.
std::optional<std::string> Trier::faultOfHelper()
{
    {
        const std::lock_guard lock(mailbox_->mutex);
        if (!mailbox_->ended && process_ > 0) {
            if (busyFor_s() < limit_s_)
                return std::nullopt;
            return fmt::format("the driver is not done with this shader after {:g} s", limit_s_);
        }
    }
    int status = 0;
    if (process_ <= 0 || ::waitpid(process_, &status, 0) != process_)
        return "no process can be started to try this shader in";
    process_ = 0;
    return WIFSIGNALED(status)
               ? fmt::format("the driver crashed over this shader ({})", ::strsignal(WTERMSIG(status)))
               : fmt::format("the driver ended the process that tried this shader (code {})",
                             WEXITSTATUS(status));
}

std::optional<TrialReply> Trier::take()
{
    if (!isBusy())
        return std::nullopt;
    std::optional<TrialReply> reply;
    {
        const std::lock_guard lock(mailbox_->mutex);
        reply = std::exchange(mailbox_->reply, std::nullopt);
    }
    if (reply && reply->number == asked_) {
        asked_ = 0;
        if (!reply->fault.empty()) { // it may have lost its context
            end();
            launch();
        }
        return reply;
    }
    const auto fault = faultOfHelper();
    if (!fault)
        return std::nullopt;
    const long number = asked_;
    cancel();
    return TrialReply{number, {}, *fault};
}

} // namespace dioptre
