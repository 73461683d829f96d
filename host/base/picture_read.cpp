#include "base/picture.h"

#include "base/error.h"
#include "base/file.h"
#include "base/picture_codecs.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{

// The content decides and not the name: pictures named .png are often JPEGs.
Picture readPicture(const std::filesystem::path& path, Encoding encoding)
{
    const std::string bytes = readFile(path);
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"))
        return decodePng(path, bytes, encoding);
    if (bytes.starts_with("\xff\xd8\xff"))
        return decodeJpeg(path, bytes, encoding);
    if (bytes.starts_with("#?RADIANCE") || bytes.starts_with("#?RGBE"))
        return decodeRadiance(path, bytes);
    if (bytes.starts_with("\x76\x2f\x31\x01"))
        return decodeExr(path, bytes);
    fail(ExitCode::badInput, {path.string()},
         bytes.empty() ? "is empty" : "is not a picture of a known format",
         "convert it to PNG, JPEG, Radiance HDR or EXR");
}

void failBroken(const std::filesystem::path& path, std::string_view what)
{
    fail(ExitCode::badInput, {path.string()}, fmt::format("is broken or cut short ({})", what),
         "fetch or save the picture again");
}

void checkSize(const std::filesystem::path& path, long long width, long long height)
{
    constexpr long long longestSide = 16384, mostTexels = longestSide * 8192;
    if (width < 1 || height < 1)
        failBroken(path, fmt::format("its size is {}x{}", width, height));
    if (width > longestSide || height > longestSide || width * height > mostTexels)
        fail(ExitCode::badInput, {path.string()}, fmt::format("is too large ({}x{} texels)", width, height),
             fmt::format("scale it down to at most {} texels on a side and {} in all, as {}x{} has",
                         longestSide, mostTexels, longestSide, mostTexels / longestSide));
}

void checkHolds(const std::filesystem::path& path, std::uintmax_t bytes, std::uintmax_t least)
{
    if (bytes < least)
        failBroken(path, fmt::format("its size takes {} bytes or more, and it holds {}", least, bytes));
}

Picture blankPicture(const std::filesystem::path& path, long long width, long long height, PixelFormat format)
{
    checkSize(path, width, height);
    Picture picture{static_cast<int>(width), static_cast<int>(height), format, {}, {}};
    const std::size_t numbers = rowLength(picture) * static_cast<std::size_t>(height);
    if (format == PixelFormat::float32)
        picture.floats.resize(numbers);
    else
        picture.bytes.resize(numbers);
    return picture;
}

std::size_t rowLength(const Picture& picture)
{
    return 4 * static_cast<std::size_t>(picture.width);
}

namespace
{

template <typename Number>
void flip(std::vector<Number>& numbers, std::size_t rowLength)
{
    for (std::size_t top = 0, bottom = numbers.size(); top + rowLength < bottom; top += rowLength) {
        bottom -= rowLength;
        const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(top);
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(rowLength),
                         numbers.begin() + static_cast<std::ptrdiff_t>(bottom));
    }
}

} // namespace

void flipRows(Picture& picture)
{
    flip(picture.bytes, rowLength(picture));
    flip(picture.floats, rowLength(picture));
}

} // namespace dioptre
