#include "base/error.h"
#include "base/picture_codecs.h"

#include <stb_image.h>

#include <algorithm>
#include <climits>
#include <memory>

namespace dioptre
{

// stb 2.27 refuses a file that was cut short, with or without progressive scans.
Picture decodeJpeg(const std::filesystem::path& path, const std::string& bytes, Encoding encoding)
{
    const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
    int width = 0, height = 0, channels = 0;
    if (bytes.size() > INT_MAX)
        fail(ExitCode::badInput, {path.string()}, "is too large", "a JPEG has at most 2 GiB");
    if (!stbi_info_from_memory(data, static_cast<int>(bytes.size()), &width, &height, &channels))
        failBroken(path, "its JPEG header cannot be read");
    checkSize(path, width, height);
    // A block of 8x8 takes a bit at least; where no component has all blocks, one has a quarter of them.
    checkHolds(path, bytes.size(),
               static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height) / 2048);
    const PixelFormat format = encoding == Encoding::linear ? PixelFormat::linear8 : PixelFormat::srgb8;
    Picture picture = blankPicture(path, width, height, format);
    const std::unique_ptr<stbi_uc, void (*)(void*)> texels(
        stbi_load_from_memory(data, static_cast<int>(bytes.size()), &width, &height, &channels, 4),
        &stbi_image_free);
    if (texels == nullptr)
        failBroken(path, stbi_failure_reason());
    std::copy_n(texels.get(), picture.bytes.size(), picture.bytes.begin());
    flipRows(picture);
    return picture;
}

} // namespace dioptre
