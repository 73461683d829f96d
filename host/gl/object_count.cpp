#include "gl/object_count.h"

#include <glad/gl.h>

#include <array>

namespace dioptre
{
namespace
{

// A name that nobody has. Drivers give the lowest that is free, or ever larger ones.
template <typename Generate, typename Delete>
GLuint freshName(Generate generate, Delete remove)
{
    GLuint name = 0;
    generate(1, &name);
    remove(1, &name);
    return name;
}

GLuint freshProgramName()
{
    const GLuint name = glCreateProgram();
    glDeleteProgram(name);
    return name;
}

} // namespace

int countGlObjects()
{
    // Where names are given again, so many leaks may lie above the fresh one and are seen all the same.
    constexpr GLuint more = 1024;
    struct Kind {
        std::array<PFNGLISPROGRAMPROC, 2> is; // shaders share the names of programs
        GLuint fresh;
    };
    const std::array kinds{
        Kind{{glIsProgram, glIsShader}, freshProgramName()},
        Kind{{glIsTexture, nullptr}, freshName(glGenTextures, glDeleteTextures)},
        Kind{{glIsBuffer, nullptr}, freshName(glGenBuffers, glDeleteBuffers)},
        Kind{{glIsFramebuffer, nullptr}, freshName(glGenFramebuffers, glDeleteFramebuffers)},
        Kind{{glIsVertexArray, nullptr}, freshName(glGenVertexArrays, glDeleteVertexArrays)}};
    int count = 0;
    for (const auto& kind : kinds)
        for (GLuint name = 1; name < kind.fresh + more; ++name)
            for (const auto is : kind.is)
                count += is != nullptr && is(name) == GL_TRUE ? 1 : 0;
    return count;
}

} // namespace dioptre
