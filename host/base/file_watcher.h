// Tells when files were saved, however their editor does it.
#pragma once

#include "base/save_burst.h"
#include "base/watched_files.h"

#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace dioptre
{

// A file has changed when its writer has closed it, when another was moved to its name or linked there, when
// a link or a folder on its way leads elsewhere, or when it is missing for longer than editors need. That a
// writer is under way is no change, nor is another time or mode of the file.
// At rest it does nothing.
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
    // the user has too many watches; then the set is unchanged.
    void watch(std::vector<std::filesystem::path> files);

    // What has changed since the last call, sorted, named as it was to watch(). From any thread. Throws
    // retry, once each time, where the thread has found that a file cannot be watched any more.
    std::vector<std::filesystem::path> changed();

private:
    void run();
    std::optional<SaveClock::time_point> due();
    bool takeChanges(); // whether there is something to tell
    void rouse() const;

    std::function<void()> wake_;
    int rouser_;       // an eventfd that ends the thread's wait
    std::mutex mutex_; // over all that follows, but the thread
    bool ending_ = false;
    WatchedFiles files_;
    SaveBurst burst_;
    std::set<std::filesystem::path> changed_;
    std::exception_ptr fault_;
    std::thread thread_;
};

} // namespace dioptre
