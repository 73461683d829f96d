// How the kernels' errors grow with scale: a sphere of every size before an eye that is 1 m away.
#pragma once

#include "stability/kernel_run.h"

#include <cstdint>
#include <vector>

namespace dioptre
{

struct ScalePoint {
    double radius_m = 1.0;
    double error = 0.0; // the larger of relative t and of the normal's angle in radians, at worst
};

// One point for each half decade of radius, 1e-5 to 1e8 m, of `rays` rays each. Only rays whose margin is
// over 64 count, and only where both the oracle and the kernel hit; a radius with none has no point.
std::vector<ScalePoint> sweepScales(const KernelDevice& device, Variant variant, std::uint64_t seed,
                                    std::size_t rays);

} // namespace dioptre
