// Pictures on the device.
#pragma once

#include "base/picture.h"
#include "gl/object.h"

#include <span>
#include <vector>

namespace dioptre
{

// An array texture of pictures of one format, with all their mip levels (trilinear, repeating both ways).
// layers[i] is the mip chain of layer i; the first is the largest, the others fill their lower left corner.
Texture uploadPictureArray(const std::vector<std::span<const Picture>>& layers);

// A single 2D float texture without mip levels (bilinear; repeats along s, clamps along t): the sky.
Texture uploadSky(const Picture& picture);

enum class TextureFilter { nearest, linear, mipmap };
enum class TextureWrap { repeat, clamp, mirror };

// One picture; the driver makes its mip levels where the filter asks for them.
Texture uploadPicture(const Picture& picture, TextureFilter filter, TextureWrap wrap);

// Six square pictures of one size, towards +x, -x, +y, -y, +z, -z; their first rows are t = 0.
Texture uploadCube(std::span<const Picture> faces, TextureFilter filter);

// A single 2D float texture for texelFetch alone: a table of numbers.
Texture uploadTable(const Picture& picture);

// A uniform buffer with the given bytes.
Buffer uploadUniformBuffer(const std::vector<float>& values);

} // namespace dioptre
