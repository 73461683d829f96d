// Loads what a window shows on a thread of its own, so that the picture goes on meanwhile.
#pragma once

#include "live/loaded.h"
#include "render/shader_device.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace dioptre
{

// What of the device texts hang on.
struct DeviceTraits {
    bool software = false;
    ShaderDevice shader;
    double drawLimit_s = 30.0;
};

class Loader
{
public:
    // `wake` is called from another thread when there is something to take.
    Loader(const DeviceTraits& device, std::function<void()> wake);
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;
    ~Loader();

    // Of several that wait the last is loaded alone; what only measures waits behind none.
    void request(LoadRequest request);

    // The same for files that changed, of what stands. From any thread.
    void again();

    // What again() asks for from now on.
    void stand(LoadRequest request);

    // The number of the last request for a picture.
    long latest() const;

    std::optional<LoadOutcome> take();

    bool isBusy() const;

private:
    void run();
    void put(LoadRequest request); // under the lock

    DeviceTraits device_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable asked_;
    std::optional<LoadRequest> request_;
    std::optional<LoadRequest> standing_;
    long number_ = 0;
    std::optional<LoadOutcome> outcome_;
    bool working_ = false;
    bool ending_ = false;
    std::thread thread_;
};

} // namespace dioptre
