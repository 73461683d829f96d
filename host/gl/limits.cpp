#include "gl/limits.h"

#include "base/error.h"
#include "gl/target.h"

#include <algorithm>
#include <array>

namespace dioptre
{
namespace
{

int integer(GLenum which)
{
    GLint value = 0;
    glGetIntegerv(which, &value);
    return value;
}

bool hasExtension(std::string_view wanted)
{
    for (int i = 0; i < integer(GL_NUM_EXTENSIONS); ++i)
        if (wanted == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))))
            return true;
    return false;
}

bool drawsIntoFloat()
{
    try {
        makeAccumulationTarget(1, 1);
        return true;
    } catch (const Error& error) {
        if (error.code() != ExitCode::noOpenGl)
            throw;
        return false;
    }
}

} // namespace

DeviceLimits deviceLimits()
{
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    DeviceLimits limits;
    limits.textureSide_px = integer(GL_MAX_TEXTURE_SIZE);
    limits.viewportWidth_px = viewport[0];
    limits.viewportHeight_px = viewport[1];
    limits.pictureSide_px = std::min({limits.textureSide_px, viewport[0], viewport[1]});
    limits.arrayLayers = integer(GL_MAX_ARRAY_TEXTURE_LAYERS);
    limits.uniformBlock_bytes = integer(GL_MAX_UNIFORM_BLOCK_SIZE);
    limits.fragmentUniformBlocks = integer(GL_MAX_FRAGMENT_UNIFORM_BLOCKS);
    limits.fragmentUniformComponents = integer(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS);
    limits.fragmentTextureUnits = integer(GL_MAX_TEXTURE_IMAGE_UNITS);
    limits.gpuShader5 = hasExtension("GL_ARB_gpu_shader5");
    limits.drawsIntoFloat = drawsIntoFloat();
    return limits;
}

} // namespace dioptre
