// A video, encoded by ffmpeg as its frames come.
#pragma once

#include "base/fed_child.h"
#include "base/file.h"
#include "base/picture.h"

#include <filesystem>
#include <memory>
#include <string>

namespace dioptre
{

// Whether the name is that of a video: .mp4, .mkv or .webm.
bool isVideo(const std::filesystem::path& path);

// A whole video or none: what is not finished is removed.
class Video
{
public:
    // `rate`: frames a second, as ffmpeg takes it. Throws toolMissing where there is no ffmpeg, usage where a
    // side is odd, cannotWrite.
    Video(const std::string& path, int width, int height, const std::string& rate);

    // R, G, B of each pixel from the top down. Throws cannotWrite with ffmpeg's words.
    void add(const std::vector<std::uint8_t>& bytes);

    // Throws cannotWrite likewise.
    void finish();

private:
    std::string path_;
    PendingFile pending_;
    std::unique_ptr<FedChild> ffmpeg_; // ends before its file goes
};

} // namespace dioptre
