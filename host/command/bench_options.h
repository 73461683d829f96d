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
// What a bench of edits takes of its options. Throws usage for several inputs and for what it does not heed.
ReloadBenchOptions reloadOptions(const BenchOptions& options);

void addBench(CLI::App& app, BenchOptions& options);

} // namespace dioptre
