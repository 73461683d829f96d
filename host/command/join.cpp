#include "command/join.h"

#include "base/clock.h"
#include "base/interruption.h"
#include "base/picture_stack.h"
#include "command/join_parts.h"
#include "command/json_text.h"
#include "command/progress.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

void refuseAPartAsOutput(const JoinOptions& options)
{
    for (const auto& part : options.parts) {
        std::error_code ignored;
        if (part == options.output || std::filesystem::equivalent(part, options.output, ignored))
            fail(ExitCode::usage, "-o " + options.output + " is one of the parts",
                 "name another file with -o");
    }
}

PictureStack stackOf(const TiledPicture& picture)
{
    PictureStack stack{{}, picture.width, picture.height, picture.settings};
    for (const auto& part : picture.topDown)
        stack.topDown.emplace_back(part);
    return stack;
}

void write(const PictureStack& stack, const std::string& output)
{
    const auto tell = terminalProgress();
    writeStack(stack, output, [&](double share) {
        Interruption::check();
        if (tell)
            tell(share);
    });
}

void printReport(const JoinOptions& options, const TiledPicture& picture, double total_ms)
{
    const nlohmann::ordered_json json = {{"output", options.output},
                                         {"size", {picture.width, picture.height}},
                                         {"tiles", picture.topDown.size()},
                                         {"total_ms", total_ms}};
    if (options.json)
        fmt::print("{}", jsonText(json));
    fmt::print(stderr, "{}: {}x{} of {} tiles\n", options.output, picture.width, picture.height,
               picture.topDown.size());
}

} // namespace

ExitCode joinTiles(const JoinOptions& options)
{
    Stopwatch whole;
    const auto kind = storedKindNamed(options.output);
    if (!kind) // before anything is read
        fail(ExitCode::usage, "-o " + options.output + " is none of .png, .hdr and .exr",
             "name FILE as the parts are");
    refuseAPartAsOutput(options);
    const TiledPicture picture = tiledPicture(options.parts);
    if (picture.kind != kind)
        fail(ExitCode::usage,
             fmt::format("-o {} is of another kind than the parts, which are {}", options.output,
                         nameOf(picture.kind)),
             "name FILE as the parts are");
    if (const int signal = signalDuring([&] { write(stackOf(picture), options.output); }); signal != 0) {
        fmt::print(stderr, "dioptre: stopped by a signal, and nothing was written\n");
        endBySignal(signal);
    }
    printReport(options, picture, whole.lap_ms());
    return ExitCode::done;
}

} // namespace dioptre
