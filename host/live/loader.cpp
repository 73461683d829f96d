#include "live/loader.h"

#include "live/load_once.h"

namespace dioptre
{

Loader::Loader(const DeviceTraits& device, std::function<void()> wake)
    : device_(device), wake_(std::move(wake)), thread_([this] { run(); })
{
}

Loader::~Loader()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void Loader::request(LoadRequest request)
{
    {
        const std::lock_guard lock(mutex_);
        if (request.measuresLost && request_)
            return;
        put(std::move(request));
    }
    asked_.notify_one();
}

void Loader::put(LoadRequest request)
{
    request.askedAt = std::chrono::steady_clock::now();
    request.number = request.measuresLost ? number_ : ++number_;
    if (!request.measuresLost)
        standing_ = request;
    request_ = std::move(request);
}

void Loader::again()
{
    {
        const std::lock_guard lock(mutex_);
        if (!standing_)
            return;
        put(*standing_);
    }
    asked_.notify_one();
}

void Loader::stand(LoadRequest request)
{
    const std::lock_guard lock(mutex_);
    standing_ = std::move(request);
}

long Loader::latest() const
{
    const std::lock_guard lock(mutex_);
    return number_;
}

std::optional<LoadOutcome> Loader::take()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
}

bool Loader::isBusy() const
{
    const std::lock_guard lock(mutex_);
    return request_.has_value() || working_ || outcome_.has_value();
}

void Loader::run()
{
    KeptForMethods kept, keptToMeasure;
    std::unique_lock lock(mutex_);
    while (true) {
        asked_.wait(lock, [this] { return ending_ || request_; });
        if (ending_)
            return;
        const LoadRequest request = *std::exchange(request_, std::nullopt);
        working_ = true;
        lock.unlock();
        LoadOutcome outcome = loadOnce(request, device_, request.measuresLost ? keptToMeasure : kept);
        lock.lock();
        working_ = false;
        outcome_ = std::move(outcome);
        wake_();
    }
}

} // namespace dioptre
