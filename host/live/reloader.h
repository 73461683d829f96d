// From a change of files or of what is wanted to a picture that is safe to show: loaded on one thread, its
// programs tried in another process, while the last picture goes on.
#pragma once

#include "base/file_watcher.h"
#include "live/loader.h"
#include "live/trier.h"

#include <mutex>
#include <optional>
#include <set>

namespace dioptre
{

// What came of a change. Without a picture there is an error.
struct ReloadOutcome {
    long number = 0; // of the request
    std::optional<Loaded> loaded;
    std::optional<Error> error;
    double compile_ms = 0.0;                   // by the helper; 0 where nothing was compiled
    double firstDraw_ms = 0.0;                 // likewise
    double waited_ms = 0.0;                    // since the request
    std::optional<std::array<double, 4>> lost; // of measureLost(), alone
};

class Reloader
{
public:
    // `wake` is called from other threads when step() has something to do.
    Reloader(const DeviceTraits& device, std::function<void()> wake);

    // Asks for a picture of what the files hold now.
    void ask(const Look& look, double time_s, const PlainFrame& frame, const Loaded* shown);

    // What is loaded when a file changes, without being asked for: the watcher's thread sees to it, while the
    // window draws.
    void stand(const Look& look, double time_s, const PlainFrame& frame, const Loaded* shown);

    // Asks how much weight a small picture loses: by cut-off, pool and budget, each a share of 1. The next
    // ask() drops it.
    void measureLost(const Look& look, double time_s, const Loaded& shown);

    // Whether to ask again: a file has changed before it was watched.
    bool hasMissedAChange();

    // Why files cannot be watched, once.
    std::optional<Error> takeWatchFault();

    // What is ready, if anything. `shown`: as it is now; null where there is nothing yet.
    std::optional<ReloadOutcome> step(const Loaded* shown);

    bool isBusy() const
    {
        return loader_.isBusy() || trier_.isBusy();
    }
    // Of the compiler, for as long as it works on what was asked for.
    double compilingFor_s() const
    {
        return measuring_ ? 0.0 : trier_.busyFor_s();
    }

private:
    std::optional<ReloadOutcome> heard(LoadOutcome outcome, const Loaded* shown);
    std::optional<ReloadOutcome> tried(const TrialReply& reply);
    LoadRequest requestOf(const Look& look, double time_s, const PlainFrame& frame,
                          const Loaded* shown) const;
    void tryPrograms(long number, const Loaded& loaded, bool toMeasure);
    void heardOfFiles();
    void tellWatchFault(const Error& error);
    void watch(const std::vector<std::filesystem::path>& files, const Loaded* shown);
    ReloadOutcome outcomeOf(const LoadRequest& request) const;

    DeviceTraits device_;
    std::mutex watchFaultMutex_;
    std::optional<Error> watchFault_;
    Loader loader_;
    FileWatcher watcher_; // it calls the loader
    Trier trier_;
    std::optional<Loaded> pending_; // its programs are being tried
    bool measuring_ = false;        // the trial is one of measureLost()
    bool changedMeanwhile_ = false; // while a file was not watched yet
};

} // namespace dioptre
