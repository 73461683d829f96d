// What an input costs from nothing: measured in processes of their own, so that no cache of this process or
// of the driver has seen it and the peak memory is its own.
#pragma once

#include "command/bench_input.h"
#include "command/bench_result.h"
#include "command/command.h"

#include <functional>

namespace dioptre
{

// One such process: prints its figures as JSON for coldStarts.
ExitCode startCold(const BenchInput& input, const BenchOptions& options);

// Runs options.coldStarts of them for each input and fills the rows' figures; rows and inputs correspond.
// Called before this process holds a context: a child's peak memory is counted from its parent's. Throws the
// child's error, and retry where one ends without a word.
void measureColdStarts(const std::vector<BenchInput>& inputs, const BenchOptions& options,
                       std::vector<BenchRow>& rows, const std::function<void(double)>& progress);

} // namespace dioptre
