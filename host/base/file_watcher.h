// Tells when files were saved, however their editor does it.
#pragma once

#include "base/inotify.h"
#include "base/path_trail.h"
#include "base/save_burst.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace dioptre
{

// A file has changed when its writer has closed it, when another was moved to its name or linked there, when
// a link or a folder on its way leads elsewhere, or when it is missing for longer than editors need. That a
// writer is under way is no change, nor is another time or mode of the file.
//
// Watched are the folders and links that lead to a file, and the file itself for those who write to it by
// another name; what is missing is awaited in the nearest folder that is there. At rest it does nothing.
class FileWatcher
{
public:
    // `wake` is called by a thread of its own once changed() has something to tell; it must not throw. Throws
    // retry where the user has too many watchers.
    explicit FileWatcher(std::function<void()> wake);
    FileWatcher(const FileWatcher&) = delete;
    FileWatcher& operator=(const FileWatcher&) = delete;
    ~FileWatcher(); // wake is not called any more

    // Replaces the set; files and folders need not be there yet. A file that stays in the set loses no
    // change; of one that is new what happens from now on is told: watch first, then read. Throws retry where
    // the user has too many watches; then the set is unchanged, but may not be watched as a whole.
    void watch(std::vector<std::filesystem::path> files);

    // What has changed since the last call, sorted, named as it was to watch(). From any thread. Throws
    // retry, once, where the thread has found that files cannot be watched any more.
    std::vector<std::filesystem::path> changed();

private:
    using Place = std::pair<int, std::string>; // a watch and a name in its folder

    struct Watched {
        PathTrail trail;
        std::set<int> folders;     // watches of those passed
        std::set<Place> turns;     // the path may lead elsewhere once one of them changes
        std::optional<Place> end;  // the file's own name, once its folder is there
        std::optional<int> itself; // watch of the file
    };
    struct Watch {
        std::uint32_t mask = 0;     // that is asked for by the files
        std::filesystem::path path; // by which it was made
    };
    using Watches = std::map<int, Watch>;

    void run();
    std::optional<SaveClock::time_point> due();
    bool takeEvents(); // whether there is something to tell
    void take(const InotifyEvent& event);
    void takeAtEnd(const std::filesystem::path& file, const InotifyEvent& event);
    void follow(const std::set<std::filesystem::path>& files);
    Watched watchTrail(const std::filesystem::path& file, Watches& asked);
    std::optional<int> ask(const std::filesystem::path& path, std::uint32_t mask, Watches& asked);
    void dropUnasked(const Watches& asked);
    void rouse() const;

    std::function<void()> wake_;
    Inotify inotify_;
    int rouser_;       // an eventfd that ends the thread's wait
    std::mutex mutex_; // over all that follows, but the thread
    bool ending_ = false;
    std::map<std::filesystem::path, Watched> files_;
    std::map<int, std::uint32_t> watches_;  // their masks in the kernel
    std::set<std::filesystem::path> moved_; // files whose path may lead elsewhere now
    bool outdated_ = false;                 // some path is to be walked again
    SaveBurst burst_;
    std::set<std::filesystem::path> changed_;
    std::exception_ptr fault_;
    std::thread thread_;
};

} // namespace dioptre
