#include "gl/object_count.h"

#include <glad/gl.h>

namespace dioptre
{

int countGlObjects()
{
    // Drivers give the lowest name that is free, so one of many leaks would still be below this.
    constexpr GLuint mostNames = 4096;
    int count = 0;
    for (GLuint name = 1; name < mostNames; ++name)
        for (const auto is :
             {glIsProgram, glIsShader, glIsTexture, glIsBuffer, glIsFramebuffer, glIsVertexArray})
            count += is(name) == GL_TRUE ? 1 : 0;
    return count;
}

} // namespace dioptre
