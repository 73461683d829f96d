#include "base/file_watcher.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

// Signals are for the thread that waits for them: none comes to a thread that is started meanwhile.
class SignalsHeldBack
{
public:
    SignalsHeldBack()
    {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    SignalsHeldBack(const SignalsHeldBack&) = delete;
    SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;
    ~SignalsHeldBack()
    {
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

private:
    sigset_t before_;
};

// Waits until either can be read, or the time has come.
void waitForEither(std::array<pollfd, 2> descriptors, std::optional<SaveClock::time_point> until)
{
    if (!until) {
        ::ppoll(descriptors.data(), descriptors.size(), nullptr, nullptr);
        return;
    }
    const auto rest =
        std::max(std::chrono::nanoseconds(*until - SaveClock::now()), std::chrono::nanoseconds(0));
    const auto whole_s = std::chrono::duration_cast<std::chrono::seconds>(rest);
    const timespec limit{.tv_sec = whole_s.count(), .tv_nsec = (rest - whole_s).count()};
    ::ppoll(descriptors.data(), descriptors.size(), &limit, nullptr);
}

} // namespace

FileWatcher::FileWatcher(std::function<void()> wake)
    : wake_(std::move(wake)), rouser_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
{
    if (rouser_ < 0)
        fail(ExitCode::retry, "files cannot be watched for changes: no descriptors are left",
             "allow more with ulimit -n");
    const SignalsHeldBack held;
    thread_ = std::thread([this] { run(); });
}

FileWatcher::~FileWatcher()
{
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
    }
    rouse();
    thread_.join();
    ::close(rouser_);
}

void FileWatcher::rouse() const
{
    ::eventfd_write(rouser_, 1);
}

void FileWatcher::watch(std::vector<fs::path> files)
{
    const std::set<fs::path> names(files.begin(), files.end());
    {
        const std::scoped_lock lock(mutex_);
        files_.replace(names);
        burst_.keepOnly(names);
        std::erase_if(changed_, [&](const fs::path& file) { return !names.contains(file); });
    }
    rouse(); // there may be something due
}

std::vector<fs::path> FileWatcher::changed()
{
    const std::scoped_lock lock(mutex_);
    if (fault_)
        std::rethrow_exception(std::exchange(fault_, nullptr));
    std::vector<fs::path> changed(changed_.begin(), changed_.end());
    changed_.clear();
    return changed;
}

void FileWatcher::run()
{
    for (;;) {
        waitForEither({{{files_.descriptor(), POLLIN, 0}, {rouser_, POLLIN, 0}}}, due());
        eventfd_t roused = 0;
        ::eventfd_read(rouser_, &roused);
        const bool hasNews = takeChanges();
        {
            const std::scoped_lock lock(mutex_);
            if (ending_)
                return;
        }
        if (hasNews)
            wake_();
    }
}

std::optional<SaveClock::time_point> FileWatcher::due()
{
    const std::scoped_lock lock(mutex_);
    return burst_.due();
}

bool FileWatcher::takeChanges()
{
    const std::scoped_lock lock(mutex_);
    const auto now = SaveClock::now();
    try {
        files_.take(burst_, now);
    } catch (...) {
        fault_ = std::current_exception();
    }
    std::set<fs::path> ready = burst_.take(now);
    const bool hasNews = !ready.empty() || fault_;
    changed_.merge(ready);
    return hasNews;
}

} // namespace dioptre
