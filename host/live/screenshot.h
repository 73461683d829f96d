// A screenshot of any size: the command line's own picture of what the window shows.
#pragma once

#include "live/model.h"

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// "still_life-1.png", or the first number that no file has yet.
std::filesystem::path freeName(const std::filesystem::path& pattern);

// What the window shows as --set says it: its changes, its camera, its display.
std::vector<std::string> valuesShown(const LiveModel& model, const Loaded& loaded);

// The words behind `dioptre` that draw it into a file.
std::vector<std::string> renderWords(const LiveModel& model, const Loaded& loaded, const std::string& size,
                                     const std::filesystem::path& file);

struct ScreenshotJob {
    std::filesystem::path file;
    std::future<std::string> fault; // "" once it is written
};

// Draws beside the window.
ScreenshotJob startScreenshot(std::vector<std::string> words, const std::filesystem::path& file,
                              const std::function<void()>& wake);

} // namespace dioptre
