// Binding a texture for a while.
#pragma once

#include <glad/gl.h>

namespace dioptre
{

// Binds `name` to the active unit and puts back what was bound there when it goes: making textures disturbs
// nobody.
class TextureBinding
{
public:
    TextureBinding(GLenum kind, GLuint name) : kind_(kind)
    {
        glGetIntegerv(kind == GL_TEXTURE_2D         ? GL_TEXTURE_BINDING_2D
                      : kind == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_BINDING_CUBE_MAP
                                                    : GL_TEXTURE_BINDING_2D_ARRAY,
                      &before_);
        glBindTexture(kind, name);
    }
    TextureBinding(const TextureBinding&) = delete;
    TextureBinding& operator=(const TextureBinding&) = delete;
    ~TextureBinding()
    {
        glBindTexture(kind_, static_cast<GLuint>(before_));
    }

private:
    GLenum kind_;
    GLint before_ = 0;
};

} // namespace dioptre
