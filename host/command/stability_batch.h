// `dioptre stability --input`: a user's own rays on the device's kernels.
#pragma once

#include "command/stability.h"

namespace dioptre
{

// Throws inputMissing, badInput, noOpenGl, cannotWrite.
ExitCode runBatch(const StabilityOptions& options);

} // namespace dioptre
