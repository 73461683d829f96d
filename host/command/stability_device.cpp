#include "command/stability_device.h"

#include "command/input.h"
#include "gl/limits.h"

#include <fmt/format.h>

#include <cstdio>

namespace dioptre
{

KernelDevice kernelDeviceHere()
{
    const auto glsl = glslFolder();
    const Guard guard = guardOf(testExactArithmetic(glsl, deviceLimits().gpuShader5));
    if (guard == Guard::none)
        fmt::print(stderr, "dioptre: this device's compiler regroups exact sums and products, so that "
                           "compensated kernels come out wrong: see dioptre doctor\n");
    return {glsl, guard};
}

} // namespace dioptre
