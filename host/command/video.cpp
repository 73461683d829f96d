#include "command/video.h"

#include "base/error.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

// A picture's sides are halved for colour (4:2:0), which every player reads.
const std::string& withEvenSides(const std::string& path, int width, int height)
{
    if (width % 2 != 0 || height % 2 != 0)
        fail(ExitCode::usage,
             fmt::format("{} would be {}x{}, and a video's sides are even", path, width, height),
             fmt::format("--size {}x{}", width + width % 2, height + height % 2));
    return path;
}

// Told as BT.709 and converted as such: without it ffmpeg converts by BT.601, and players of large pictures
// read BT.709.
std::vector<std::string> commandFor(const std::filesystem::path& file, int width, int height,
                                    const std::string& rate)
{
    std::vector<std::string> command = {"ffmpeg", "-hide_banner", "-nostats", "-loglevel", "error", "-y"};
    const auto add = [&](std::initializer_list<std::string> words) { command.insert(command.end(), words); };
    add({"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", width, height)});
    add({"-framerate", rate, "-i", "pipe:0", "-an"});
    add({"-vf", "scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p"});
    add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"});
    if (file.extension() == ".webm")
        add({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0"});
    else
        add({"-c:v", "libx264", "-crf", "18"});
    if (file.extension() == ".mp4")
        add({"-movflags", "+faststart"});
    add({"file:" + file.string()});
    return command;
}

[[noreturn]] void failOfFfmpeg(const std::string& path, const ChildOutcome& outcome)
{
    const std::string how =
        outcome.signal != 0 ? fmt::format("signal {}", outcome.signal) : fmt::format("code {}", outcome.code);
    std::string words = outcome.error;
    while (!words.empty() && words.back() == '\n')
        words.pop_back();
    fail(ExitCode::cannotWrite, {path},
         fmt::format("ffmpeg ended with {}: {}", how, words.empty() ? "it says nothing" : words),
         "mend what ffmpeg names, or write numbered pictures with -o FILE.png");
}

} // namespace

bool isVideo(const std::filesystem::path& path)
{
    const auto extension = path.extension();
    return extension == ".mp4" || extension == ".mkv" || extension == ".webm";
}

Video::Video(const std::string& path, int width, int height, const std::string& rate)
    : path_(withEvenSides(path, width, height)), pending_(path),
      ffmpeg_(FedChild::start(commandFor(pending_.path(), width, height, rate)))
{
    if (ffmpeg_ == nullptr)
        fail(ExitCode::toolMissing, path + " needs ffmpeg, and it cannot be started",
             "install it (Debian's package ffmpeg), or write numbered pictures with -o FILE.png");
}

void Video::add(const std::vector<std::uint8_t>& bytes)
{
    if (!ffmpeg_->write(bytes))
        failOfFfmpeg(path_, ffmpeg_->finish());
}

void Video::finish()
{
    const ChildOutcome outcome = ffmpeg_->finish();
    if (outcome.code != 0 || outcome.signal != 0)
        failOfFfmpeg(path_, outcome);
    pending_.commit();
}

} // namespace dioptre
