// A screenshot of any size: the command line's own picture of what the window shows.
#pragma once

#include "base/fed_child.h"
#include "live/model.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace dioptre
{

// "still_life-1.png", or the first number that no file has yet.
std::filesystem::path freeName(const std::filesystem::path& pattern);

// What the window shows as --set says it: its changes, its camera, its display. `read`: the uniforms that a
// plain shader reads; those that it only declares are refused by --set.
std::vector<std::string> valuesShown(const LiveModel& model, const Loaded& loaded,
                                     const std::vector<std::string>& read);

// The words behind `dioptre` that draw it into a file.
std::vector<std::string> renderWords(const LiveModel& model, const Loaded& loaded,
                                     const std::vector<std::string>& read, const std::string& size,
                                     const std::filesystem::path& file);

// What of the window such a picture cannot show, as the end of a notice: ", of trace alone".
std::string whatShotLacks(const MethodChoice& methods);

// Draws beside the window. One that is dropped before its end leaves no file.
class ScreenshotJob
{
public:
    ScreenshotJob(std::vector<std::string> words, const std::filesystem::path& file);
    ScreenshotJob(const ScreenshotJob&) = delete;
    ScreenshotJob& operator=(const ScreenshotJob&) = delete;
    ~ScreenshotJob();

    const std::filesystem::path& file() const
    {
        return file_;
    }
    bool isDone() const
    {
        return child_ == nullptr || child_->hasEnded();
    }
    // What went wrong, in words; "" where it is written. Waits until it is done.
    std::string fault();

private:
    std::filesystem::path file_;
    std::unique_ptr<FedChild> child_; // null where none could be started
};

} // namespace dioptre
