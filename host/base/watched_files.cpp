#include "base/watched_files.h"

#include "base/open_writer.h"

#include <algorithm>
#include <sys/inotify.h>
#include <system_error>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

constexpr std::uint32_t itsFate = IN_MOVE_SELF | IN_DELETE_SELF;
constexpr std::uint32_t itsNames = IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO;
// A tree that is moved about without a pause is left to the events that this brings.
constexpr int mostWalks = 8;

PathTrail trailOfName(const fs::path& name)
{
    std::error_code fault; // of the empty name, or a working folder that is gone
    return trailOf(fs::absolute(name, fault));
}

// A file without content may be one that its writer has but just made.
bool isWhole(const fs::path& file)
{
    std::error_code fault;
    return (!fs::is_regular_file(file, fault) || fs::file_size(file, fault) > 0) && !hasWriter(file);
}

} // namespace

void WatchedFiles::replace(const std::set<fs::path>& names)
{
    std::map<fs::path, Watched> added;
    for (const fs::path& name : names)
        if (!files_.contains(name))
            added.emplace(name, watchTrail(name));
    const auto left = std::erase_if(files_, [&](const auto& one) { return !names.contains(one.first); });
    const bool isSame = added.empty() && left == 0;
    files_.merge(added);
    if (!isSame)
        dropUnasked();
}

void WatchedFiles::take(SaveBurst& burst, SaveClock::time_point now)
{
    for (const InotifyEvent& event : inotify_.read())
        take(event, burst, now);
    bool isSame = true;
    for (auto& [name, file] : files_)
        if (file.isStale) {
            followAgain(name, file, burst, now);
            isSame = false;
        }
    if (!isSame)
        dropUnasked();
}

void WatchedFiles::take(const InotifyEvent& event, SaveBurst& burst, SaveClock::time_point now)
{
    const bool lost = (event.mask & IN_Q_OVERFLOW) != 0;
    // The kernel has dropped the watch; we did not, or it would be known no more.
    const bool gone = (event.mask & IN_IGNORED) != 0 && watches_.erase(event.watch) > 0;
    const bool fate = (event.mask & (itsFate | IN_UNMOUNT)) != 0;
    const bool named = !event.name.empty();
    const Place place(event.watch, event.name);
    for (auto& [name, file] : files_) {
        const bool turned = named && (event.mask & itsNames) != 0 && file.turns.contains(place);
        const bool uprooted =
            (gone || fate) && event.watch != file.itself && file.asked.contains(event.watch);
        file.isMoved |= lost || turned || uprooted;
        file.isStale |= file.isMoved || (gone && event.watch == file.itself);
        if (named && file.end == place)
            takeAtEnd(name, file, event, burst, now);
        else if (!named && (event.mask & IN_CLOSE_WRITE) != 0 && file.itself == event.watch)
            burst.saved(name, now);
    }
}

void WatchedFiles::takeAtEnd(const fs::path& name, Watched& file, const InotifyEvent& event, SaveBurst& burst,
                             SaveClock::time_point now)
{
    std::error_code fault;
    const bool linked = (event.mask & IN_CREATE) != 0 && fs::hard_link_count(name, fault) > 1 && !fault;
    if ((event.mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0 || linked)
        burst.saved(name, now);
    else
        burst.vanished(name, now); // or begins to be written
    file.isStale |= (event.mask & itsNames) != 0;
}

void WatchedFiles::followAgain(const fs::path& name, Watched& file, SaveBurst& burst,
                               SaveClock::time_point now)
{
    Watched found = watchTrail(name);
    const bool isOther = file.isMoved || !found.trail.leadsLike(file.trail);
    const bool existed = file.trail.exists;
    file = std::move(found);
    if (!isOther || !(existed || file.trail.exists))
        return;
    if (file.trail.exists && isWhole(name))
        burst.saved(name, now);
    else
        burst.vanished(name, now); // or it is not written yet
}

// What changes after a folder is watched brings an event; what did before is seen by another walk.
WatchedFiles::Watched WatchedFiles::watchTrail(const fs::path& name)
{
    Watched watched = watchAlong(trailOfName(name));
    for (int walk = 1; walk < mostWalks; ++walk) {
        PathTrail now = trailOfName(name);
        if (now.leadsLike(watched.trail))
            break;
        watched = watchAlong(std::move(now));
    }
    return watched;
}

WatchedFiles::Watched WatchedFiles::watchAlong(PathTrail trail)
{
    Watched watched;
    for (const fs::path& folder : trail.folders)
        ask(folder, itsFate | IN_ONLYDIR, watched);
    for (const FolderEntry& link : trail.links)
        if (const auto watch = ask(link.folder, itsNames | IN_ONLYDIR, watched))
            watched.turns.emplace(*watch, link.name);
    const std::uint32_t ofEnd = itsNames | IN_ONLYDIR | (trail.whole ? IN_CLOSE_WRITE : 0U);
    if (const auto watch = ask(trail.end.folder, ofEnd, watched)) {
        if (trail.whole)
            watched.end.emplace(*watch, trail.end.name);
        else
            watched.turns.emplace(*watch, trail.end.name);
    }
    std::error_code fault;
    const fs::path itself = trail.end.folder / trail.end.name;
    if (trail.exists && !fs::is_directory(itself, fault))
        watched.itself = ask(itself, IN_CLOSE_WRITE, watched);
    watched.trail = std::move(trail);
    return watched;
}

std::optional<int> WatchedFiles::ask(const fs::path& path, std::uint32_t mask, Watched& file)
{
    const std::optional<int> watch = inotify_.watch(path, mask | IN_MASK_ADD | IN_DONT_FOLLOW);
    if (!watch)
        return std::nullopt;
    Watch& one = watches_[*watch];
    one.path = path;
    one.mask |= mask;
    file.asked[*watch] |= mask;
    return watch;
}

void WatchedFiles::dropUnasked()
{
    std::map<int, std::uint32_t> asked;
    for (const auto& [name, file] : files_)
        for (const auto& [watch, mask] : file.asked)
            asked[watch] |= mask;
    std::erase_if(watches_, [&](const auto& one) {
        const bool isUnasked = !asked.contains(one.first);
        if (isUnasked)
            inotify_.drop(one.first);
        return isUnasked;
    });
    // A folder that was once looked into may now be but passed: its names are to wake no one.
    for (auto& [watch, one] : watches_) {
        const std::uint32_t mask = asked.at(watch);
        if (one.mask == mask)
            continue;
        const auto found = inotify_.watch(one.path, mask | IN_DONT_FOLLOW);
        if (found == watch)
            one.mask = mask;
        else if (found) // another is at its path now: the loss of its watch makes it be looked at anew
            inotify_.drop(*found);
    }
}

} // namespace dioptre
