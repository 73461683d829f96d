// What the kernel is asked to tell of so that no change of a set of files is missed, and what its tidings
// mean.
#pragma once

#include "base/inotify.h"
#include "base/path_trail.h"
#include "base/save_burst.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace dioptre
{

// Watched are the folders and links that lead to a file, and the file itself for those who write to it by
// another name; what is missing is awaited in the nearest folder that is there.
class WatchedFiles
{
public:
    int descriptor() const // readable when take() has something to do
    {
        return inotify_.descriptor();
    }

    // Replaces the set. Files that stay in it cost next to nothing and lose no tidings. Throws retry where
    // the user has too many watches; then the set is unchanged.
    void replace(const std::set<std::filesystem::path>& names);

    // Takes the tidings that have come, as of `now`, tells `burst` which files were saved or have vanished,
    // and follows them to where their paths lead now. Throws retry as above; what is undone then is tried
    // with the next.
    void take(SaveBurst& burst, SaveClock::time_point now);

private:
    using Place = std::pair<int, std::string>; // a watch and a name in its folder

    struct Watched {
        PathTrail trail;
        std::map<int, std::uint32_t> asked; // watches, and what of them
        std::set<Place> turns;              // the path may lead elsewhere once one of them changes
        std::optional<Place> end;           // the file's own name, once its folder is there
        std::optional<int> itself;          // watch of the file
        bool isStale = false;               // another file or folder is to be watched, perhaps
        bool isMoved = false;               // stale, and its path may lead to another file
    };
    struct Watch {
        std::filesystem::path path; // by which it was made
        std::uint32_t mask = 0;     // in the kernel
    };

    void take(const InotifyEvent& event, SaveBurst& burst, SaveClock::time_point now);
    void takeAtEnd(const std::filesystem::path& name, Watched& file, const InotifyEvent& event,
                   SaveBurst& burst, SaveClock::time_point now);
    void followAgain(const std::filesystem::path& name, Watched& file, SaveBurst& burst,
                     SaveClock::time_point now);
    Watched watchTrail(const std::filesystem::path& name);
    Watched watchAlong(PathTrail trail);
    std::optional<int> ask(const std::filesystem::path& path, std::uint32_t mask, Watched& file);
    void dropUnasked();

    Inotify inotify_;
    std::map<std::filesystem::path, Watched> files_;
    std::map<int, Watch> watches_;
};

} // namespace dioptre
