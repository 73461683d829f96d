// How long an edit takes to reach the window, measured by editing.
#pragma once

#include "command/command.h"

#include <string>
#include <vector>

namespace dioptre
{

// Of one kind of edit, one number an edit.
struct ReloadRow {
    std::string name;
    std::vector<double> shown_ms;   // from the end of the save to the end of the first swap that shows it
    std::vector<double> frames;     // the same, in frames of the running picture
    std::vector<double> compile_ms; // by the helper, through its first draw; empty where nothing is compiled
    std::vector<double> gap; // longest time between two frames meanwhile, in usual frames; while it runs
};

struct ReloadResult {
    std::string renderer;
    double frame_ms = 0.0; // usual, of the running picture
    double cold_ms = 0.0;  // compile through first draw, as bench has it
    std::vector<ReloadRow> rows;
};

std::string reloadText(const ReloadResult& result, const ReloadBenchOptions& options);
std::string reloadJson(const ReloadResult& result, const ReloadBenchOptions& options);

} // namespace dioptre
