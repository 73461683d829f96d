// Pictures on the device.
#pragma once

#include "base/picture.h"
#include "gl/object.h"

#include <span>
#include <vector>

namespace dioptre
{

// What a texture is apart from its contents: enough to compile a program against it.
struct TextureShape {
    GLenum target = GL_TEXTURE_2D; // or GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP
    GLenum stored = GL_RGBA8;
    GLenum numberType = GL_UNSIGNED_BYTE; // in which contents are handed over
    int width = 1;                        // of level 0, texels
    int height = 1;
    int layers = 1; // of an array
    int levels = 1; // that are stored, each half as large as the one before
    GLenum minification = GL_LINEAR;
    GLenum magnification = GL_LINEAR;
    GLenum wrapS = GL_REPEAT;
    GLenum wrapT = GL_REPEAT;
};

// Contents are undefined. Throws badInput beyond the driver's limits and retry without memory.
Texture makeTexture(const TextureShape& shape);

// An array texture of pictures of one format, with all their mip levels (trilinear, repeating both ways).
// layers[i] is the mip chain of layer i; the first is the largest, the others fill their lower left corner.
TextureShape shapeOfPictureArray(const std::vector<std::span<const Picture>>& layers);
Texture uploadPictureArray(const std::vector<std::span<const Picture>>& layers);

// A single 2D float texture without mip levels (bilinear; repeats along s, clamps along t): the sky.
TextureShape shapeOfSky(const Picture& picture);
Texture uploadSky(const Picture& picture);

enum class TextureFilter { nearest, linear, mipmap };
enum class TextureWrap { repeat, clamp, mirror };

// One picture; the driver makes its mip levels where the filter asks for them.
TextureShape shapeOfPicture(const Picture& picture, TextureFilter filter, TextureWrap wrap);
Texture uploadPicture(const Picture& picture, const TextureShape& shape);

// Six square pictures of one size, towards +x, -x, +y, -y, +z, -z; their first rows are t = 0.
TextureShape shapeOfCube(std::span<const Picture> faces, TextureFilter filter);
Texture uploadCube(std::span<const Picture> faces, const TextureShape& shape);

// A single 2D float texture for texelFetch alone: a table of numbers.
Texture uploadTable(const Picture& picture);

// A uniform buffer with the given bytes.
Buffer uploadUniformBuffer(const std::vector<float>& values);

} // namespace dioptre
