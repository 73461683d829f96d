// What the kernels run on, for the commands.
#pragma once

#include "stability/kernel_run.h"

namespace dioptre
{

// The current context's, its exact arithmetic tested; warns where none can be had.
KernelDevice kernelDeviceHere();

} // namespace dioptre
