#include "gl/texture.h"

#include "base/error.h"
#include "gl/texture_binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

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

int levelSize(int size, int level)
{
    return std::max(1, size >> level);
}

int levelsOf(int width, int height)
{
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
}

// A single texture without further levels, of a picture's size and format.
TextureShape shapeOf(const Picture& picture)
{
    const Layout layout = layoutOf(picture.format);
    TextureShape shape;
    shape.stored = layout.stored;
    shape.numberType = layout.numberType;
    shape.width = picture.width;
    shape.height = picture.height;
    return shape;
}

void setFilter(TextureShape& shape, TextureFilter filter)
{
    const bool nearest = filter == TextureFilter::nearest;
    const bool levels = filter == TextureFilter::mipmap;
    shape.levels = levels ? levelsOf(shape.width, shape.height) : 1;
    shape.minification = levels ? GL_LINEAR_MIPMAP_LINEAR : nearest ? GL_NEAREST : GL_LINEAR;
    shape.magnification = nearest ? GL_NEAREST : GL_LINEAR;
}

void checkLimits(const TextureShape& shape)
{
    const bool cube = shape.target == GL_TEXTURE_CUBE_MAP;
    checkLimit(cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, std::max(shape.width, shape.height),
               cube ? "texels on a side of a cube" : "texels on a side");
    if (shape.target == GL_TEXTURE_2D_ARRAY)
        checkLimit(GL_MAX_ARRAY_TEXTURE_LAYERS, shape.layers, "pictures of one size");
}

void allocate(const TextureShape& shape, int level)
{
    const auto stored = static_cast<GLint>(shape.stored);
    const int width = levelSize(shape.width, level), height = levelSize(shape.height, level);
    if (shape.target == GL_TEXTURE_2D_ARRAY) {
        glTexImage3D(shape.target, level, stored, width, height, shape.layers, 0, GL_RGBA, shape.numberType,
                     nullptr);
        return;
    }
    const bool cube = shape.target == GL_TEXTURE_CUBE_MAP;
    for (GLenum face = 0; face < (cube ? 6U : 1U); ++face)
        glTexImage2D((cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : shape.target) + face, level, stored, width,
                     height, 0, GL_RGBA, shape.numberType, nullptr);
}

// Fills level 0 of a 2D texture or of a cube's face.
void fill(GLenum image, const Picture& picture)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(image, 0, 0, 0, picture.width, picture.height, GL_RGBA,
                    layoutOf(picture.format).numberType, numbersOf(picture));
}

Texture uploadSingle(const TextureShape& shape, const Picture& picture)
{
    Texture texture = makeTexture(shape);
    const TextureBinding binding(shape.target, texture.name());
    fill(shape.target, picture);
    if (shape.levels > 1)
        glGenerateMipmap(shape.target);
    checkUploaded();
    return texture;
}

} // namespace

Texture makeTexture(const TextureShape& shape)
{
    checkLimits(shape);
    GLuint name = 0;
    glGenTextures(1, &name);
    Texture texture(name);
    const TextureBinding binding(shape.target, name);
    for (int level = 0; level < shape.levels; ++level)
        allocate(shape, level);
    for (const auto& [setting, value] :
         {std::pair{GL_TEXTURE_MAX_LEVEL, static_cast<GLenum>(shape.levels - 1)},
          {GL_TEXTURE_MIN_FILTER, shape.minification},
          {GL_TEXTURE_MAG_FILTER, shape.magnification},
          {GL_TEXTURE_WRAP_S, shape.wrapS},
          {GL_TEXTURE_WRAP_T, shape.wrapT},
          {GL_TEXTURE_WRAP_R, shape.wrapT}})
        glTexParameteri(shape.target, static_cast<GLenum>(setting), static_cast<GLint>(value));
    checkUploaded();
    return texture;
}

TextureShape shapeOfPictureArray(const std::vector<std::span<const Picture>>& layers)
{
    const std::span<const Picture> first = layers.at(0);
    TextureShape shape = shapeOf(first.front());
    shape.target = GL_TEXTURE_2D_ARRAY;
    shape.layers = static_cast<int>(layers.size());
    shape.levels = static_cast<int>(first.size());
    shape.minification = GL_LINEAR_MIPMAP_LINEAR;
    return shape;
}

Texture uploadPictureArray(const std::vector<std::span<const Picture>>& layers)
{
    const TextureShape shape = shapeOfPictureArray(layers);
    Texture texture = makeTexture(shape);
    const TextureBinding binding(shape.target, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t layer = 0; layer < layers.size(); ++layer)
        for (std::size_t level = 0; level < layers[layer].size(); ++level)
            glTexSubImage3D(shape.target, static_cast<GLint>(level), 0, 0, static_cast<GLint>(layer),
                            layers[layer][level].width, layers[layer][level].height, 1, GL_RGBA,
                            shape.numberType, numbersOf(layers[layer][level]));
    checkUploaded();
    return texture;
}

TextureShape shapeOfSky(const Picture& picture)
{
    TextureShape shape = shapeOf(picture);
    shape.wrapT = GL_CLAMP_TO_EDGE;
    return shape;
}

Texture uploadSky(const Picture& picture)
{
    return uploadSingle(shapeOfSky(picture), picture);
}

namespace
{

GLenum wrapOf(TextureWrap wrap)
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

TextureShape shapeOfPicture(const Picture& picture, TextureFilter filter, TextureWrap wrap)
{
    TextureShape shape = shapeOf(picture);
    setFilter(shape, filter);
    shape.wrapS = wrapOf(wrap);
    shape.wrapT = wrapOf(wrap);
    return shape;
}

Texture uploadPicture(const Picture& picture, const TextureShape& shape)
{
    return uploadSingle(shape, picture);
}

TextureShape shapeOfCube(std::span<const Picture> faces, TextureFilter filter)
{
    TextureShape shape = shapeOf(faces.front());
    shape.target = GL_TEXTURE_CUBE_MAP;
    setFilter(shape, filter);
    shape.wrapS = GL_CLAMP_TO_EDGE;
    shape.wrapT = GL_CLAMP_TO_EDGE;
    return shape;
}

Texture uploadCube(std::span<const Picture> faces, const TextureShape& shape)
{
    Texture texture = makeTexture(shape);
    const TextureBinding binding(shape.target, texture.name());
    for (std::size_t i = 0; i < faces.size(); ++i)
        fill(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), faces[i]);
    if (shape.levels > 1)
        glGenerateMipmap(shape.target);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    checkUploaded();
    return texture;
}

// Nearest: float tables need not be filterable.
Texture uploadTable(const Picture& picture)
{
    return uploadSingle(shapeOfPicture(picture, TextureFilter::nearest, TextureWrap::clamp), picture);
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
