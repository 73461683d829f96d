#include "render/shader_device.h"

#include <glad/gl.h>

#include <algorithm>

namespace dioptre
{

ShaderDevice shaderDevice(const std::filesystem::path& glslFolder, bool exactSums)
{
    GLint outputs = 0;
    GLint varyings = 0;
    GLint inputs = 0;
    glGetIntegerv(GL_MAX_VERTEX_OUTPUT_COMPONENTS, &outputs);
    glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &varyings);
    glGetIntegerv(GL_MAX_FRAGMENT_INPUT_COMPONENTS, &inputs);
    ShaderDevice device;
    device.sharedVectors = std::min(mostSharedVectors, std::min({outputs, varyings, inputs}) / 4);
    if (exactSums)
        device.guard = findGuard(glslFolder);
    return device;
}

} // namespace dioptre
