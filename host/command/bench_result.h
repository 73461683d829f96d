// What `dioptre bench` measured, and how it is told.
#pragma once

#include "gl/context.h"

#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// The figures of one input, a value for each round.
struct BenchRow {
    std::string name;
    std::vector<double> frame_ms;
    // Of cold starts, each in a process of its own:
    std::vector<double> compile_ms;
    std::vector<double> firstDraw_ms;
    std::vector<double> ready_ms; // compile through first draw
    std::vector<double> peak_mib; // through a frame
    double raysPerPixel = 0.0;    // of all samples of a frame
};

// A tracer in plain Python on the first input's scene file.
struct PlainTracer {
    std::string scene;
    long pixels = 0;       // that it drew
    double drawn_ms = 0.0; // in which time
    double frame_ms = 0.0; // that a whole frame takes at that pace
};

struct BenchResult {
    ContextInfo context;
    std::string clock;
    int width = 0;   // pixels
    int height = 0;  // pixels
    int samples = 0; // a pixel
    std::size_t warmUpFrames = 0;
    std::vector<BenchRow> inputs;
    BenchRow control; // the first input a second time
    std::optional<PlainTracer> plainTracer;
};

// Tables of medians and their ratios to the first input.
std::string benchTables(const BenchResult& result);

// One JSON object; see the README for its keys.
std::string benchJson(const BenchResult& result);

} // namespace dioptre
