// Tries programs in a process of its own, so that what hangs or crashes a driver never meets the window.
#pragma once

#include "live/trial_message.h"

#include <chrono>
#include <functional>
#include <memory>

namespace dioptre
{

class Trier
{
public:
    // `wake` is called from another thread when there is something to take. The helper starts at once, so
    // that the first edit finds it ready.
    explicit Trier(std::function<void()> wake);
    Trier(const Trier&) = delete;
    Trier& operator=(const Trier&) = delete;
    ~Trier();

    // Drops what is under way. A helper that is still busy with it is ended, and a new one started.
    void start(long number, std::vector<ProgramTrial> trials, double drawLimit_s);
    void cancel();

    bool isBusy() const
    {
        return asked_ != 0;
    }
    double busyFor_s() const;

    // The reply to what was started last. A helper that died or took too long is a fault of the program that
    // it tried.
    std::optional<TrialReply> take();

private:
    struct Helper;

    void launch();
    void dismiss();
    void send();
    bool hasDied() const;
    std::optional<std::string> faultOfHelper();

    std::function<void()> wake_;
    std::shared_ptr<Helper> helper_; // null where none could be started
    long asked_ = 0;                 // 0: nothing is under way
    std::vector<std::uint8_t> sent_; // the last message
    bool wasKilled_ = false;         // a helper, over that message
    std::chrono::steady_clock::time_point askedAt_;
    double limit_s_ = 0.0;
};

} // namespace dioptre
