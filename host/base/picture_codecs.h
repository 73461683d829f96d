// One decoder for each file format that readPicture knows, and what they share.
#pragma once

#include "base/picture.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace dioptre
{

// Each decodes the bytes of a whole file and flips it, so that row 0 is the bottom. `path` is for the
// messages. They throw badInput for what is broken, cut short or too large.
Picture decodePng(const std::filesystem::path& path, const std::string& bytes, Encoding encoding);
Picture decodeJpeg(const std::filesystem::path& path, const std::string& bytes, Encoding encoding);
Picture decodeRadiance(const std::filesystem::path& path, const std::string& bytes);
Picture decodeExr(const std::filesystem::path& path, const std::string& bytes);

// A picture of the right size, all zero. Throws badInput for more than 16384 texels on a side: no device
// takes them, and the header of a broken file must not claim all memory.
Picture blankPicture(const std::filesystem::path& path, long long width, long long height,
                     PixelFormat format);

// Throws badInput: the file is not what it says it is.
[[noreturn]] void failBroken(const std::filesystem::path& path, std::string_view what);

// Numbers in a row of RGBA.
std::size_t rowLength(const Picture& picture);

// Turns the rows around: files run from the top down.
void flipRows(Picture& picture);

} // namespace dioptre
