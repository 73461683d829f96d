// `dioptre stability`: the kernels on the device against the quad-precision oracle.
#pragma once

#include "base/error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace dioptre
{

struct StabilityOptions {
    std::vector<std::string> cases; // of the table; all where empty
    std::string backend = "auto";
    std::uint64_t seed = 1;
    int rays = 20000; // of each case
    std::string csv;  // file for the table; "" for none
    std::string plot; // file for a chart, .svg; "" for none
    bool json = false;
    std::string input;   // file of rays and shapes to run in place of the cases; "" for none
    std::string output;  // file for what they hit
    std::string variant; // textbook, robust, compensated or curvature; "" or auto for each row's strictest
};

void addStability(CLI::App& app, StabilityOptions& options);

// Gives checkFailed where a gate is broken.
ExitCode stability(const StabilityOptions& options);

} // namespace dioptre
