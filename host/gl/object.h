// Move-only owners of OpenGL object names.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace dioptre
{

// Deletes its name with `Delete` when it goes; 0 owns nothing.
template <void (*Delete)(GLuint)>
class GlObject
{
public:
    GlObject() = default;
    explicit GlObject(GLuint name) : name_(name) {}
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject()
    {
        if (name_ != 0)
            Delete(name_);
    }
    GLuint name() const
    {
        return name_;
    }

private:
    GLuint name_ = 0;
};

namespace gl_delete
{
inline void texture(GLuint name)
{
    glDeleteTextures(1, &name);
}
inline void buffer(GLuint name)
{
    glDeleteBuffers(1, &name);
}
inline void framebuffer(GLuint name)
{
    glDeleteFramebuffers(1, &name);
}
inline void vertexArray(GLuint name)
{
    glDeleteVertexArrays(1, &name);
}
inline void shader(GLuint name)
{
    glDeleteShader(name);
}
inline void program(GLuint name)
{
    glDeleteProgram(name);
}
inline void query(GLuint name)
{
    glDeleteQueries(1, &name);
}
} // namespace gl_delete

using Texture = GlObject<gl_delete::texture>;
using Buffer = GlObject<gl_delete::buffer>;
using Framebuffer = GlObject<gl_delete::framebuffer>;
using VertexArray = GlObject<gl_delete::vertexArray>;
using Shader = GlObject<gl_delete::shader>;
using ProgramName = GlObject<gl_delete::program>;
using Query = GlObject<gl_delete::query>;

} // namespace dioptre
