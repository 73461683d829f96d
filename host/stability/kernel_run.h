// The GLSL kernels at work on problems, on the current context's device.
#pragma once

#include "render/exact_arithmetic.h"
#include "stability/judge.h"
#include "stability/kernel_rows.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace dioptre
{

struct KernelDevice {
    std::filesystem::path glslFolder;
    Guard guard = Guard::none; // of compensated arithmetic
};

// Answers by one variant, or by each problem's strictest; a kind that the variant is not for runs
// compensated. A problem of a kind that is none is a miss.
std::vector<DeviceAnswer> runKernels(const KernelDevice& device, std::span<const RayProblem> problems,
                                     std::optional<Variant> variant, Frame frame);

} // namespace dioptre
