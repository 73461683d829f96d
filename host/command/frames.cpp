#include "command/frames.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/interruption.h"
#include "command/draw_picture.h"
#include "command/frame_range.h"
#include "command/frames_report.h"
#include "command/progress.h"
#include "command/render_steps.h"
#include "command/settings_hash.h"
#include "command/trust_account.h"
#include "command/video.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

void refuseBadFrames(const RenderOptions& options, const FrameRange& range)
{
    if (!(options.fps > 0.0 && std::isfinite(options.fps)))
        fail(ExitCode::usage, fmt::format("--fps {} is no rate", options.fps),
             "give a number of frames a second above 0");
    const double last_s = timeOf(range.last, options.time_s, options.fps);
    if (!(std::abs(last_s) <= static_cast<double>(std::numeric_limits<float>::max())))
        fail(ExitCode::usage, fmt::format("frame {} would be at {} s", range.last, last_s),
             "give more frames a second, or fewer frames");
    if (!options.layers.empty())
        fail(ExitCode::usage, "--layers is for one picture", "ask without --frames");
    if (options.why || !options.shader.empty())
        fail(ExitCode::usage, "--why and --shader speak of one picture",
             "ask without --frames: the shader is the same at every time");
    if (!isVideo(options.output))
        return;
    if (options.resume)
        fail(ExitCode::usage, "--resume is for numbered pictures, and " + options.output + " is a video",
             "leave it out, or write -o FILE.png");
    if (options.output.find('#') != std::string::npos)
        fail(ExitCode::usage, "-o " + options.output + ": a video holds all frames and has no number",
             "leave out the #");
}

// The frames with times, and with files where each has its own.
std::vector<Frame> framesOf(const RenderOptions& options, const FrameRange& range)
{
    const auto numbers = numbersOf(range);
    std::vector<Frame> frames;
    for (const int number : numbers)
        frames.push_back({number, timeOf(number, options.time_s, options.fps), "", false, {}});
    if (isVideo(options.output))
        return frames;
    const FrameNames names(options.output, numbers.back());
    for (auto& frame : frames)
        frame.output = names.of(frame.number);
    return frames;
}

// The options of a still that is this frame.
RenderOptions optionsOf(const RenderOptions& options, const Frame& frame, const PictureDrawer& drawer,
                        unsigned long long sources)
{
    RenderOptions still = options;
    still.time_s = frame.time_s;
    if (frame.output.empty())
        return still;
    still.output = frame.output;
    still.settingsHash = settingsHash(still, drawer.context(), sources);
    return still;
}

bool isThere(const RenderOptions& still)
{
    const auto settings = readSettings(still.output);
    const auto hash = settings.find("dioptre.hash");
    if (hash == settings.end() || hash->second != still.settingsHash)
        return false;
    try {
        readPicture(still.output); // to its last byte
        return true;
    } catch (const Error&) {
        return false;
    }
}

// As ffmpeg takes it: with steps left out, frames follow one another more slowly and the video runs true.
std::string rateOf(const RenderOptions& options, const FrameRange& range)
{
    return range.step == 1 ? fmt::format("{}", options.fps) : fmt::format("{}/{}", options.fps, range.step);
}

// Draws what is not there yet. Throws retry where a signal asks it to stop.
void drawFrames(FramesReport& report, const RenderOptions& options, PictureDrawer& drawer, Video* video)
{
    const unsigned long long sources = video != nullptr ? 0 : drawer.sourcesFingerprint();
    if (options.resume)
        for (auto& frame : report.frames)
            frame.kept = isThere(optionsOf(options, frame, drawer, sources));
    const auto missing = std::ranges::count(report.frames, false, &Frame::kept);
    const auto tell = terminalProgressOfFrames(static_cast<std::size_t>(missing));
    const auto progress = [&](double share) {
        if (tell)
            tell(static_cast<double>(report.drawn) + share);
    };
    const TrustAccount trust(options);
    for (auto& frame : report.frames) {
        if (frame.kept)
            continue;
        Stopwatch watch;
        drawer.moveTo(frame.time_s);
        const double load_ms = watch.lap_ms();
        const auto beyondTrust = trust(drawer);
        const RenderOptions own = optionsOf(options, frame, drawer, sources);
        const PictureFigures figures =
            drawPicture(drawer, own, video, tell ? Progress(progress) : Progress());
        frame.figures = {figures.phases, figures.raysPerPixel(), figures.counts.nonfinite, beyondTrust};
        frame.figures.phases.load += load_ms;
        ++report.drawn;
        progress(0.0);
    }
}

void drawAll(FramesReport& report, const RenderOptions& options, const Input& input, const FrameRange& range)
{
    std::unique_ptr<PictureDrawer> drawer; // ends after the video, whose file goes first
    std::unique_ptr<Video> video;
    if (isVideo(options.output))
        video =
            std::make_unique<Video>(options.output, options.width, options.height, rateOf(options, range));
    else
        // What cannot be written, or is neither kind of picture, is refused before anything is drawn.
        PendingFile{report.frames.front().output};
    drawer =
        std::make_unique<PictureDrawer>(options, input, report.frames.front().time_s, rowsAtOnce(options));
    report.context = drawer->context();
    report.made = drawer->made();
    drawFrames(report, options, *drawer, video.get());
    Interruption::check();
    Stopwatch watch;
    if (video)
        video->finish();
    report.finish_ms = watch.lap_ms();
}

} // namespace

ExitCode renderFrames(const RenderOptions& options, const Input& input)
{
    Stopwatch whole;
    const FrameRange range = readFrameRange(options.frames);
    refuseBadFrames(options, range);
    FramesReport report;
    report.frames = framesOf(options, range);
    const int signal = signalDuring([&] { drawAll(report, options, input, range); });
    if (signal != 0) {
        fmt::print(stderr, "dioptre: stopped by a signal after {} frames{}\n", report.drawn,
                   isVideo(options.output) ? "; a part of a video is not kept"
                                           : ": --resume goes on from there");
        endBySignal(signal);
    }
    report.total_ms = whole.lap_ms();
    printReport(report, options, range);
    return ExitCode::done;
}

} // namespace dioptre
