#include "kernel/reference.h"

#include "compiled_fingerprint.h" // made by the build from glsl/

namespace dioptre
{

unsigned long long compiledShaderFingerprint()
{
    return compiledFingerprint;
}

} // namespace dioptre
