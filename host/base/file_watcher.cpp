#include "base/file_watcher.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <system_error>
#include <unistd.h>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

constexpr std::uint32_t itsFate = IN_MOVE_SELF | IN_DELETE_SELF;
constexpr std::uint32_t itsNames = IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO;
// A tree that is moved about without a pause is left to the events that this brings.
constexpr int mostWalks = 8;

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

// Waits until one of them can be read, or the time has come.
void waitFor(std::array<pollfd, 2> descriptors, std::optional<SaveClock::time_point> until)
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
        follow(names);
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
        waitFor({{{inotify_.descriptor(), POLLIN, 0}, {rouser_, POLLIN, 0}}}, due());
        eventfd_t roused = 0;
        ::eventfd_read(rouser_, &roused);
        const bool news = takeEvents();
        {
            const std::scoped_lock lock(mutex_);
            if (ending_)
                return;
        }
        if (news)
            wake_();
    }
}

std::optional<SaveClock::time_point> FileWatcher::due()
{
    const std::scoped_lock lock(mutex_);
    return burst_.due();
}

bool FileWatcher::takeEvents()
{
    const std::scoped_lock lock(mutex_);
    try {
        for (const InotifyEvent& event : inotify_.read())
            take(event);
        if (outdated_) {
            std::set<fs::path> names;
            for (const auto& [name, file] : files_)
                names.insert(name);
            follow(names);
        }
    } catch (...) {
        fault_ = std::current_exception();
        return true;
    }
    std::set<fs::path> ready = burst_.take(SaveClock::now());
    const bool news = !ready.empty();
    changed_.merge(ready);
    return news;
}

void FileWatcher::take(const InotifyEvent& event)
{
    const bool lost = (event.mask & IN_Q_OVERFLOW) != 0;
    // The kernel has dropped the watch; we did not, or it would be known no more.
    const bool gone = (event.mask & IN_IGNORED) != 0 && watches_.erase(event.watch) > 0;
    const bool fate = (event.mask & (itsFate | IN_UNMOUNT)) != 0;
    const Place place(event.watch, event.name);
    outdated_ |= lost || gone;
    for (const auto& [name, file] : files_) {
        const bool turned = !event.name.empty() && (event.mask & itsNames) != 0 && file.turns.contains(place);
        if (lost || turned || ((gone || fate) && file.folders.contains(event.watch))) {
            moved_.insert(name);
            outdated_ = true;
        }
        if (!event.name.empty() && file.end == place)
            takeAtEnd(name, event);
        else if (event.name.empty() && (event.mask & IN_CLOSE_WRITE) != 0 && file.itself == event.watch)
            burst_.saved(name, SaveClock::now());
    }
}

void FileWatcher::takeAtEnd(const fs::path& file, const InotifyEvent& event)
{
    std::error_code fault;
    const bool linked = (event.mask & IN_CREATE) != 0 && fs::hard_link_count(file, fault) > 1 && !fault;
    if ((event.mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0 || linked)
        burst_.saved(file, SaveClock::now());
    else
        burst_.vanished(file, SaveClock::now()); // or begins to be written
    outdated_ |= (event.mask & itsNames) != 0;   // another file is to be watched
}

void FileWatcher::follow(const std::set<fs::path>& names)
{
    std::map<fs::path, Watched> files;
    Watches asked;
    const auto leadsAsBefore = [](const auto& one) {
        return trailOf(fs::absolute(one.first)).leadsLike(one.second.trail);
    };
    // What changes after a folder is watched brings an event; what did before is seen by another walk.
    for (int walk = 0; walk == 0 || (walk < mostWalks && !std::ranges::all_of(files, leadsAsBefore));
         ++walk) {
        files.clear();
        asked.clear();
        for (const fs::path& name : names)
            files.emplace(name, watchTrail(name, asked));
    }
    dropUnasked(asked);
    const std::map<fs::path, Watched> before = std::exchange(files_, std::move(files));
    for (const auto& [name, file] : files_) {
        const auto old = before.find(name);
        if (old == before.end() || (!moved_.contains(name) && old->second.trail.leadsLike(file.trail)))
            continue;
        if (file.trail.exists)
            burst_.saved(name, SaveClock::now());
        else if (old->second.trail.exists)
            burst_.vanished(name, SaveClock::now());
    }
    moved_.clear();
    outdated_ = false;
}

FileWatcher::Watched FileWatcher::watchTrail(const fs::path& file, Watches& asked)
{
    Watched watched; watched.trail = trailOf(fs::absolute(file));
    const PathTrail& trail = watched.trail;
    for (const fs::path& folder : trail.folders)
        if (const auto watch = ask(folder, itsFate | IN_ONLYDIR, asked))
            watched.folders.insert(*watch);
    for (const FolderEntry& link : trail.links)
        if (const auto watch = ask(link.folder, itsNames | IN_ONLYDIR, asked))
            watched.turns.emplace(*watch, link.name);
    const std::uint32_t ofEnd = itsNames | IN_ONLYDIR | (trail.whole ? IN_CLOSE_WRITE : 0U);
    if (const auto watch = ask(trail.end.folder, ofEnd, asked)) {
        if (trail.whole)
            watched.end.emplace(*watch, trail.end.name);
        else
            watched.turns.emplace(*watch, trail.end.name);
    }
    std::error_code fault;
    const fs::path itself = trail.end.folder / trail.end.name;
    if (trail.exists && !fs::is_directory(itself, fault))
        watched.itself = ask(itself, IN_CLOSE_WRITE, asked);
    return watched;
}

std::optional<int> FileWatcher::ask(const fs::path& path, std::uint32_t mask, Watches& asked)
{
    const std::optional<int> watch = inotify_.watch(path, mask | IN_MASK_ADD | IN_DONT_FOLLOW);
    if (!watch)
        return std::nullopt;
    watches_[*watch] |= mask;
    Watch& one = asked[*watch];
    one.mask |= mask;
    one.path = path;
    return watch;
}

void FileWatcher::dropUnasked(const Watches& asked)
{
    std::erase_if(watches_, [&](const auto& one) {
        const bool unasked = !asked.contains(one.first);
        if (unasked)
            inotify_.drop(one.first);
        return unasked;
    });
    // A folder that was once looked into may now be but passed: its names are to wake no one.
    for (const auto& [watch, one] : asked)
        if (watches_[watch] != one.mask && inotify_.watch(one.path, one.mask | IN_DONT_FOLLOW) == watch)
            watches_[watch] = one.mask;
}

} // namespace dioptre
