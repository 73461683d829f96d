// What is said of frames that were drawn.
#pragma once

#include "command/command.h"
#include "command/frame_range.h"
#include "gl/context.h"
#include "render/still.h"

#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

struct FrameFigures {
    Phases phases;
    double raysPerPixel = 0.0;
    std::size_t nonfinite = 0;         // pixels
    std::optional<double> beyondTrust; // as TrustAccount has it
};

struct Frame {
    int number = 0;
    double time_s = 0.0;
    std::string output;   // "" in a video
    bool kept = false;    // it was there already
    FrameFigures figures; // of what was drawn
};

struct FramesReport {
    std::vector<Frame> frames;
    std::size_t drawn = 0;
    ContextInfo context;
    Phases made;            // once for all frames
    double finish_ms = 0.0; // the end of a video
    double total_ms = 0.0;
};

// The figures as JSON on standard output where asked for; a line on standard error.
void printReport(const FramesReport& report, const RenderOptions& options, const FrameRange& range);

} // namespace dioptre
