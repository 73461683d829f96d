#include "live/trier.h"

#include "base/child_process.h"
#include "live/helper.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace dioptre
{
namespace
{

// For a driver's compiler: the largest shaders known take some ten seconds.
constexpr double compileLimit_s = 60.0;

using Clock = std::chrono::steady_clock;

// Gives 0 where it cannot be started. `input` and `output` are its ends of pipes.
pid_t spawnHelper(int input, int output)
{
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    std::string program = "/proc/self/exe", word = helperWord;
    const std::array<char*, 3> arguments{program.data(), word.data(), nullptr};
    pid_t process = 0;
    if (::posix_spawn(&process, program.c_str(), &actions, nullptr, arguments.data(), environ) != 0)
        process = 0;
    posix_spawn_file_actions_destroy(&actions);
    return process;
}

} // namespace

// One helper, as the window's thread and the one that speaks with the helper know it.
struct Trier::Helper {
    pid_t process = 0;
    int input = -1, output = -1; // our ends of its pipes

    std::mutex mutex; // over what follows
    std::condition_variable asked;
    std::vector<std::uint8_t> message; // to be sent
    std::optional<TrialReply> reply;
    bool dismissed = false;    // nobody waits for it any more
    std::optional<int> status; // of its end

    // Whatever a stuck or dying process does to its pipes holds up this thread alone.
    void converse(const std::function<void()>& wake);
};

void Trier::Helper::converse(const std::function<void()>& wake)
{
    std::unique_lock lock(mutex);
    for (bool answers = true; answers;) {
        asked.wait(lock, [this] { return dismissed || !message.empty(); });
        if (dismissed)
            break;
        const auto bytes = std::exchange(message, {});
        lock.unlock();
        auto heard = writeAll(input, bytes) ? readTrialReply(output) : std::nullopt;
        lock.lock();
        answers = heard.has_value();
        reply = std::move(heard);
        if (answers && !dismissed)
            wake();
    }
    ::close(input); // it ends by this where nobody has ended it
    ::close(output);
    lock.unlock();
    siginfo_t ended{};
    while (::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
    }
    lock.lock(); // so that no signal meets another process of this number
    int code = 0;
    ::waitpid(process, &code, 0);
    status = code;
    if (!dismissed)
        wake();
}

Trier::Trier(std::function<void()> wake) : wake_(std::move(wake))
{
    std::signal(SIGPIPE, SIG_IGN); // a helper that died reads no more
    launch();
}

Trier::~Trier()
{
    dismiss();
}

void Trier::launch()
{
    std::array<int, 2> in{}, out{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0)
        return;
    if (::pipe2(out.data(), O_CLOEXEC) != 0) {
        ::close(in[0]);
        ::close(in[1]);
        return;
    }
    const pid_t process = spawnHelper(in[0], out[1]);
    ::close(in[0]);
    ::close(out[1]);
    if (process == 0) {
        ::close(in[1]);
        ::close(out[0]);
        return;
    }
    helper_ = std::make_shared<Helper>();
    helper_->process = process;
    helper_->input = in[1];
    helper_->output = out[0];
    std::thread([helper = helper_, wake = wake_] { helper->converse(wake); }).detach();
}

// Its end is not waited for: a driver may hold it in the kernel.
void Trier::dismiss()
{
    if (const auto helper = std::exchange(helper_, nullptr)) {
        const std::lock_guard lock(helper->mutex);
        helper->dismissed = true;
        if (!helper->status)
            ::kill(helper->process, SIGKILL);
        helper->asked.notify_one();
    }
}

// By itself, while nobody spoke with it.
bool Trier::hasDied() const
{
    const std::lock_guard lock(helper_->mutex);
    return helper_->status || hasEnded(helper_->process);
}

void Trier::start(long number, std::vector<ProgramTrial> trials, double drawLimit_s)
{
    cancel();
    asked_ = number;
    limit_s_ = compileLimit_s + drawLimit_s * static_cast<double>(trials.size());
    sent_ = bytesOf(TrialMessage{number, drawLimit_s, std::move(trials)});
    wasKilled_ = false;
    send();
}

void Trier::send()
{
    if (helper_ != nullptr && hasDied())
        dismiss();
    if (helper_ == nullptr)
        launch();
    askedAt_ = Clock::now();
    if (helper_ == nullptr)
        return; // take() tells
    const std::lock_guard lock(helper_->mutex);
    helper_->message = sent_;
    helper_->asked.notify_one();
}

void Trier::cancel()
{
    if (asked_ == 0)
        return;
    asked_ = 0;
    dismiss();
    launch();
}

double Trier::busyFor_s() const
{
    return isBusy() ? std::chrono::duration<double>(Clock::now() - askedAt_).count() : 0.0;
}

// In words, of one that is no more or is to be no more; of one that goes on nothing.
std::optional<std::string> Trier::faultOfHelper()
{
    if (helper_ == nullptr)
        return "no process can be started to try this shader in";
    std::optional<int> status;
    {
        const std::lock_guard lock(helper_->mutex);
        status = helper_->status;
    }
    if (!status && busyFor_s() < limit_s_)
        return std::nullopt;
    if (!status)
        return fmt::format("the driver is not done with this shader after {:g} s", limit_s_);
    if (WIFEXITED(*status))
        return fmt::format("the driver ended the process that tried this shader (code {})",
                           WEXITSTATUS(*status));
    if (WTERMSIG(*status) != SIGKILL)
        return fmt::format("the driver crashed over this shader ({})", ::strsignal(WTERMSIG(*status)));
    // No driver does that, but somebody, or a system that is short of memory: the shader may be innocent.
    if (!std::exchange(wasKilled_, true)) {
        send();
        return std::nullopt;
    }
    return "the process that tried this shader was killed, twice: memory may be short";
}

std::optional<TrialReply> Trier::take()
{
    if (!isBusy()) {
        if (helper_ != nullptr && hasDied())
            dismiss(); // the next trial starts another
        return std::nullopt;
    }
    std::optional<TrialReply> reply;
    if (helper_ != nullptr) {
        const std::lock_guard lock(helper_->mutex);
        reply = std::exchange(helper_->reply, std::nullopt);
    }
    if (!reply) {
        const auto fault = faultOfHelper();
        if (!fault)
            return std::nullopt;
        const long number = asked_;
        cancel();
        return TrialReply{number, {}, *fault};
    }
    asked_ = 0;
    if (!reply->fault.empty()) { // it may have lost its context
        dismiss();
        launch();
    }
    return reply;
}

} // namespace dioptre
