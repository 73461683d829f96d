#include "gl/texture.h"

#include "base/error.h"
#include "gl/texture_binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace dioptre
{
namespace
{

// How the device stores a picture, and how its numbers are handed over.
struct Layout {
    GLenum stored;
    GLenum numberType;
};

Layout layoutOf(PixelFormat format)
{
    switch (format) {
    case PixelFormat::srgb8:
        return {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE};
    case PixelFormat::linear8:
        return {GL_RGBA8, GL_UNSIGNED_BYTE};
    case PixelFormat::float32:
        break;
    }
    return {GL_RGBA32F, GL_FLOAT};
}

const void* numbersOf(const Picture& picture)
{
    return picture.format == PixelFormat::float32 ? static_cast<const void*>(picture.floats.data())
                                                  : static_cast<const void*>(picture.bytes.data());
}

Texture newTexture()
{
    GLuint name = 0;
    glGenTextures(1, &name);
    return Texture(name);
}

void setSampling(GLenum kind, GLenum minification, GLenum wrapS, GLenum wrapT)
{
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minification));
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrapS));
    glTexParameteri(kind, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrapT));
}

void checkLimit(GLenum limit, long long size, const char* what)
{
    GLint longest = 0;
    glGetIntegerv(limit, &longest);
    if (size > longest)
        fail(ExitCode::badInput, fmt::format("{} {} is more than this OpenGL takes", size, what),
             fmt::format("use at most {}", longest));
}

// Errors of the device alone are looked for here: it may lack the memory.
void checkUploaded()
{
    if (glGetError() == GL_OUT_OF_MEMORY)
        fail(ExitCode::retry, "the device has no memory left for the pictures", "use fewer or smaller ones");
}

// One picture without mip levels; sampling is left to the caller.
Texture uploadSingle(const Picture& picture)
{
    const Layout layout = layoutOf(picture.format);
    checkLimit(GL_MAX_TEXTURE_SIZE, std::max(picture.width, picture.height), "texels on a side");
    Texture texture = newTexture();
    const TextureBinding binding(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(layout.stored), picture.width, picture.height, 0,
                 GL_RGBA, layout.numberType, numbersOf(picture));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    checkUploaded();
    return texture;
}

} // namespace

Texture uploadPictureArray(const std::vector<std::span<const Picture>>& layers)
{
    constexpr GLenum kind = GL_TEXTURE_2D_ARRAY;
    const std::span<const Picture> first = layers.at(0);
    const Layout layout = layoutOf(first.front().format);
    const auto layerCount = static_cast<GLsizei>(layers.size());
    checkLimit(GL_MAX_TEXTURE_SIZE, std::max(first[0].width, first[0].height), "texels on a side");
    checkLimit(GL_MAX_ARRAY_TEXTURE_LAYERS, layerCount, "pictures of one size");
    Texture texture = newTexture();
    const TextureBinding binding(kind, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t level = 0; level < first.size(); ++level) {
        const int width = first[level].width, height = first[level].height;
        const auto levelNumber = static_cast<GLint>(level);
        glTexImage3D(kind, levelNumber, static_cast<GLint>(layout.stored), width, height, layerCount, 0,
                     GL_RGBA, layout.numberType, nullptr);
        for (std::size_t layer = 0; layer < layers.size(); ++layer)
            if (level < layers[layer].size())
                glTexSubImage3D(kind, levelNumber, 0, 0, static_cast<GLint>(layer),
                                layers[layer][level].width, layers[layer][level].height, 1, GL_RGBA,
                                layout.numberType, numbersOf(layers[layer][level]));
    }
    glTexParameteri(kind, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(first.size()) - 1);
    setSampling(kind, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT, GL_REPEAT);
    checkUploaded();
    return texture;
}

Texture uploadSky(const Picture& picture)
{
    Texture texture = uploadSingle(picture);
    const TextureBinding binding(GL_TEXTURE_2D, texture.name());
    setSampling(GL_TEXTURE_2D, GL_LINEAR, GL_REPEAT, GL_CLAMP_TO_EDGE);
    return texture;
}

namespace
{

void setFilter(GLenum kind, TextureFilter filter)
{
    const bool nearest = filter == TextureFilter::nearest;
    const bool levels = filter == TextureFilter::mipmap;
    glTexParameteri(kind, GL_TEXTURE_MAX_LEVEL, levels ? 1000 : 0);
    if (levels)
        glGenerateMipmap(kind);
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER,
                    levels    ? GL_LINEAR_MIPMAP_LINEAR
                    : nearest ? GL_NEAREST
                              : GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
}

GLint wrapOf(TextureWrap wrap)
{
    switch (wrap) {
    case TextureWrap::clamp:
        return GL_CLAMP_TO_EDGE;
    case TextureWrap::mirror:
        return GL_MIRRORED_REPEAT;
    case TextureWrap::repeat:
        break;
    }
    return GL_REPEAT;
}

} // namespace

Texture uploadPicture(const Picture& picture, TextureFilter filter, TextureWrap wrap)
{
    Texture texture = uploadSingle(picture);
    const TextureBinding binding(GL_TEXTURE_2D, texture.name());
    setFilter(GL_TEXTURE_2D, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapOf(wrap));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapOf(wrap));
    checkUploaded();
    return texture;
}

Texture uploadCube(std::span<const Picture> faces, TextureFilter filter)
{
    constexpr GLenum kind = GL_TEXTURE_CUBE_MAP;
    checkLimit(GL_MAX_CUBE_MAP_TEXTURE_SIZE, faces.front().width, "texels on a side of a cube");
    Texture texture = newTexture();
    const TextureBinding binding(kind, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Layout layout = layoutOf(faces[i].format);
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), 0,
                     static_cast<GLint>(layout.stored), faces[i].width, faces[i].height, 0, GL_RGBA,
                     layout.numberType, numbersOf(faces[i]));
    }
    setFilter(kind, filter);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(kind, axis, GL_CLAMP_TO_EDGE);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    checkUploaded();
    return texture;
}

// Nearest: float tables need not be filterable.
Texture uploadTable(const Picture& picture)
{
    Texture texture = uploadSingle(picture);
    const TextureBinding binding(GL_TEXTURE_2D, texture.name());
    setSampling(GL_TEXTURE_2D, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

Buffer uploadUniformBuffer(const std::vector<float>& values)
{
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_UNIFORM_BUFFER, name);
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    return Buffer(name);
}

} // namespace dioptre
