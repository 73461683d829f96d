// Tries programs in a process of its own, so that what hangs or crashes a driver never meets the window.
#pragma once

#include "live/trial_message.h"

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

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
    struct Mailbox; // what the reading thread leaves

    void launch();
    void end();
    bool hasEnded() const;
    std::optional<std::string> faultOfHelper();

    std::function<void()> wake_;
    int process_ = 0;
    int input_ = -1;
    std::shared_ptr<Mailbox> mailbox_;
    std::thread reader_;
    long asked_ = 0; // 0: nothing is under way
    std::chrono::steady_clock::time_point askedAt_;
    double limit_s_ = 0.0;
};

} // namespace dioptre
