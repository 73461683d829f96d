// Pictures whose headers lie, byte by byte.
#pragma once

#include <cstdint>
#include <string>

namespace dioptre::test
{

// Its checksums are right. Of one grey channel, `bits` each; the body is a few compressed zeros.
std::string forgedPng(std::uint32_t width, std::uint32_t height, int bits = 8);

// A PNG that keeps its word: black, one bit a texel, row upon row.
std::string blackPng(std::uint32_t width, std::uint32_t height);

// A PNG of one texel with `bytes` zeros of compressed text beside it.
std::string pngWithText(std::size_t bytes);

// A start of frame and no scan.
std::string forgedJpeg(std::uint16_t width, std::uint16_t height);

// A JPEG that keeps its word: grey, 8x8 texels, one block of the DC coefficient alone, so that every texel is
// 128 + 64 * 8 / 8 = 192.
std::string greyJpeg();

// A header and 64 bytes.
std::string forgedRadiance(const std::string& sizeLine);

struct Window {
    std::int32_t left, top, right, bottom; // the ends included
};

// Scan lines of half floats R, G and B, without compression; the chunks' places and what is in them are left
// out. `extra`: further bytes of the header.
std::string forgedExr(const Window& data, const Window& display, const std::string& extra = "");

// An attribute of an EXR's header, of as many bytes as `size` says, whatever there are.
std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value,
                         std::int32_t size);

// The number's four bytes, the lowest first.
std::string littleEndian(std::uint32_t number);

} // namespace dioptre::test
