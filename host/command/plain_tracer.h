// The tracer in plain Python that bench --python holds the shader to.
#pragma once

#include "command/bench_input.h"
#include "command/bench_result.h"
#include "command/command.h"

namespace dioptre
{

// Throws toolMissing without python3, inputMissing without the tracer, badInput for a scene that it cannot
// draw.
PlainTracer runPlainTracer(const BenchInput& input, const BenchOptions& options);

} // namespace dioptre
