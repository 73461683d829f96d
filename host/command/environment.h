// What of the process's surroundings explains a driver's times.
#pragma once

#include "gl/context.h"

#include <string>

namespace dioptre
{

struct DriverEnvironment {
    std::string shaderCache;  // "on" where its thread runs; "off" where the reason is known; else "unknown"
    std::string cacheReason;  // where it is, or why there is none
    int rasterThreads = 0;    // threads of llvmpipe; 0 where the caller's thread draws, or no llvmpipe does
    std::string threadsAsked; // $LP_NUM_THREADS; "" where unset
    int cores = 0;            // that this process may use
};

// Asks the system, after a context was made: the driver's threads say more than the variables that it reads.
DriverEnvironment driverEnvironment(const ContextInfo& context);

} // namespace dioptre
