#include "support/forged_pictures.h"

#include <spng.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace dioptre::test
{
namespace
{

const std::string pngSignature = "\x89PNG\r\n\x1a\n";

std::string bigEndian(std::uint32_t number)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(number >> shift);
    return bytes;
}

// PNG, 3rd edition, annex D.
std::uint32_t crcOf(const std::string& bytes)
{
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

std::string chunk(const std::string& type, const std::string& content)
{
    return bigEndian(static_cast<std::uint32_t>(content.size())) + type + content +
           bigEndian(crcOf(type + content));
}

void check(int outcome)
{
    if (outcome != 0)
        throw std::runtime_error(spng_strerror(outcome));
}

// What libspng makes of black rows and of text that is to be compressed.
std::string encodedPng(std::uint32_t width, std::uint32_t height, std::string text)
{
    spng_ctx* context = spng_ctx_new(SPNG_CTX_ENCODER);
    check(spng_set_option(context, SPNG_ENCODE_TO_BUFFER, 1));
    check(spng_set_option(context, SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING));
    spng_ihdr header{};
    header.width = width;
    header.height = height;
    header.bit_depth = 1;
    header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
    check(spng_set_ihdr(context, &header));
    spng_text entry{};
    std::string keyword = "Comment";
    keyword.copy(entry.keyword, keyword.size());
    entry.type = SPNG_ZTXT;
    entry.length = text.size();
    entry.text = text.data();
    if (!text.empty())
        check(spng_set_text(context, &entry, 1));
    check(
        spng_encode_image(context, nullptr, 0, SPNG_FMT_PNG, SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE));
    const std::vector<char> row((width + 7) / 8, '\0');
    for (std::uint32_t y = 0; y < height; ++y) {
        const int outcome = spng_encode_row(context, row.data(), row.size());
        if (outcome != SPNG_EOI)
            check(outcome);
    }
    std::size_t size = 0;
    int outcome = 0;
    void* const bytes = spng_get_png_buffer(context, &size, &outcome);
    check(outcome);
    std::string result(static_cast<const char*>(bytes), size);
    std::free(bytes);
    spng_ctx_free(context);
    return result;
}

} // namespace

std::string forgedPng(std::uint32_t width, std::uint32_t height, int bits)
{
    const std::string header =
        bigEndian(width) + bigEndian(height) + static_cast<char>(bits) + std::string(4, '\0');
    // zlib's stream of 16 zeros, stored.
    const std::string body =
        std::string("\x78\x01\x01\x10\x00\xEF\xFF", 7) + std::string(16, '\0') + bigEndian(0x00100001);
    return pngSignature + chunk("IHDR", header) + chunk("IDAT", body) + chunk("IEND", "");
}

std::string blackPng(std::uint32_t width, std::uint32_t height)
{
    return encodedPng(width, height, "");
}

std::string pngWithText(std::size_t bytes)
{
    return encodedPng(1, 1, std::string(bytes, ' '));
}

std::string forgedJpeg(std::uint16_t width, std::uint16_t height)
{
    std::string bytes("\xFF\xD8\xFF\xC0\x00\x11\x08", 7); // 8 bits a number
    bytes += bigEndian((static_cast<std::uint32_t>(height) << 16) | width);
    bytes += std::string("\x03\x01\x11\x00\x02\x11\x00\x03\x11\x00", 10); // three components
    return bytes + std::string(1000, '\0');
}

std::string greyJpeg()
{
    std::string bytes("\xFF\xD8", 2);
    bytes += std::string("\xFF\xDB\x00\x43\x00", 5) + std::string(64, '\x08');        // all divide by 8
    bytes += std::string("\xFF\xC0\x00\x0B\x08\x00\x08\x00\x08\x01\x01\x11\x00", 13); // 8x8, one component
    // One code for DC: "0" is category 7. One for AC: "0" is the end of the block.
    bytes += std::string("\xFF\xC4\x00\x14\x00\x01", 6) + std::string(15, '\0') + '\x07';
    bytes += std::string("\xFF\xC4\x00\x14\x10\x01", 6) + std::string(15, '\0') + '\0';
    bytes += std::string("\xFF\xDA\x00\x08\x01\x01\x00\x00\x3F\x00", 10);
    // 0, 1000000 = 64, 0, and ones to the end of the byte.
    bytes += std::string("\x40\x7F", 2);
    return bytes + std::string("\xFF\xD9", 2);
}

std::string forgedRadiance(const std::string& sizeLine)
{
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + sizeLine + "\n" + std::string(64, '\2');
}

std::string littleEndian(std::uint32_t number)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(number >> shift);
    return bytes;
}

std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value,
                         std::int32_t size)
{
    return name + '\0' + type + '\0' + littleEndian(static_cast<std::uint32_t>(size)) + value;
}

// https://openexr.com/en/latest/OpenEXRFileLayout.html
std::string forgedExr(const Window& data, const Window& display, const std::string& extra)
{
    const auto attribute = [](const std::string& name, const std::string& type, const std::string& value) {
        return exrAttribute(name, type, value, static_cast<std::int32_t>(value.size()));
    };
    const auto number = [](std::int32_t value) { return littleEndian(static_cast<std::uint32_t>(value)); };
    const auto box = [&](const Window& of) {
        return number(of.left) + number(of.top) + number(of.right) + number(of.bottom);
    };
    std::string channels;
    for (const char* name : {"B", "G", "R"})
        channels += std::string(name) + '\0' + number(1) + number(0) + number(1) + number(1);
    const std::string one = littleEndian(0x3F800000); // as a float
    return littleEndian(20000630) + number(2) + attribute("channels", "chlist", channels + '\0') +
           attribute("compression", "compression", std::string(1, '\0')) +
           attribute("dataWindow", "box2i", box(data)) + attribute("displayWindow", "box2i", box(display)) +
           attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", one) +
           attribute("screenWindowCenter", "v2f", number(0) + number(0)) +
           attribute("screenWindowWidth", "float", one) + extra + '\0' + std::string(64, '\0');
}

} // namespace dioptre::test
