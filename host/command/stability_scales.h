// The chart of `dioptre stability --plot`.
#pragma once

#include "command/stability.h"
#include "stability/kernel_run.h"

namespace dioptre
{

// Error against scale, a line a variant, into options.plot. Throws cannotWrite.
void writeScalePlot(const KernelDevice& device, const StabilityOptions& options);

} // namespace dioptre
