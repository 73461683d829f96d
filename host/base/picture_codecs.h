// One decoder for each file format that readPicture knows, and what they share.
#pragma once

#include "base/picture.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace dioptre
{

// Bytes of a PNG's text and profiles: compressed ones are unpacked beside the pixels, to any size.
inline constexpr std::size_t mostBesidePixels = std::size_t{64} << 20;

// Each decodes the bytes of a whole file and flips it, so that row 0 is the bottom. `path` is for the
// messages. They throw badInput for what is broken, cut short or too large.
Picture decodePng(const std::filesystem::path& path, const std::string& bytes, Encoding encoding);
Picture decodeJpeg(const std::filesystem::path& path, const std::string& bytes, Encoding encoding);
Picture decodeRadiance(const std::filesystem::path& path, const std::string& bytes);
Picture decodeExr(const std::filesystem::path& path, const std::string& bytes);

// Throws badInput for more than 16384 texels on a side, which no device takes, and for more than 16384 * 8192
// in all: a sky of the largest side. A small file must not claim all memory.
void checkSize(const std::filesystem::path& path, long long width, long long height);

// Throws badInput where a file holds fewer bytes than its format could bring its picture down to: what a
// header claims is doubted before memory is taken for it.
void checkHolds(const std::filesystem::path& path, std::uintmax_t bytes, std::uintmax_t least);

// A picture of the right size, all zero. Throws as checkSize().
Picture blankPicture(const std::filesystem::path& path, long long width, long long height,
                     PixelFormat format);

// Throws badInput: the file is not what it says it is.
[[noreturn]] void failBroken(const std::filesystem::path& path, std::string_view what);

// Numbers in a row of RGBA.
std::size_t rowLength(const Picture& picture);

// Turns the rows around: files run from the top down.
void flipRows(Picture& picture);

} // namespace dioptre
