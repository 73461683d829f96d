// The options of `dioptre bench`.
#pragma once

#include "command/command.h"

namespace CLI
{
class App;
}

namespace dioptre
{

// Adds the command; parsing fills `options`, which must live that long.
void addBench(CLI::App& app, BenchOptions& options);

} // namespace dioptre
