// Pictures in memory, their files, and their chain of smaller levels.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// How the numbers of a picture are to be read. Four channels (RGBA) in every case.
enum class PixelFormat {
    srgb8,   // bytes, sRGB-encoded colour, alpha linear
    linear8, // bytes, linear
    float32  // linear radiance or data
};

// Rows run from the bottom up: row 0 is v = 0, as OpenGL wants it; the loaders flip.
struct Picture {
    int width = 0;  // texels
    int height = 0; // texels
    PixelFormat format = PixelFormat::float32;
    std::vector<std::uint8_t> bytes; // 4 * width * height, for the 8-bit formats
    std::vector<float> floats;       // 4 * width * height, for float32
};

// float32, all numbers 0.
inline Picture blankFloats(int width, int height)
{
    const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, PixelFormat::float32, {}, std::vector<float>(4 * texels)};
}

enum class Encoding { automatic, srgb, linear };

// Reads PNG, JPEG, Radiance HDR or EXR, told by content and not by name. Colour pictures of 8 bits are srgb8
// unless `encoding` says otherwise or the PNG's gAMA is 1.0. Throws inputMissing or badInput.
Picture readPicture(const std::filesystem::path& path, Encoding encoding = Encoding::automatic);

// Linear RGBA of one texel, decoded as the format says.
std::array<float, 4> linearTexel(const Picture& picture, int x, int y);

// The picture and its halvings down to 1x1 by a 2x2 box filter taken in linear light (floor of odd sizes, as
// OpenGL).
std::vector<Picture> mipmaps(Picture picture);

// IEC 61966-2-1. Linear 1.0 is white; values outside 0..1 are clamped, NaN gives 0.
std::uint8_t srgb8FromLinear(float linear);
float linearFromSrgb8(std::uint8_t encoded);

// Key and value pairs for a PNG's tEXt chunks, an EXR's header or a Radiance picture's: what made the
// picture.
using Settings = std::map<std::string, std::string>;

// How a PNG holds the numbers of a float32 picture.
struct PngForm {
    bool encode = true;            // by the sRGB curve or by `gamma`; otherwise 0..1 are scaled
    std::optional<double> gamma{}; // x^(1/gamma) in place of sRGB, which the gAMA chunk then says; above 0
    int bits = 8;                  // a channel: 8 or 16
};

// The bytes of an 8-bit PNG's pixels: R, G, B of each, rows from the top down.
std::vector<std::uint8_t> topDownBytes(const Picture& picture, const PngForm& form);

// Writes the R, G, B of a picture: of 8 bits as they stand, of floats in that form. Values outside 0..1 are
// clamped, NaN gives 0. Throws cannotWrite.
void writePng(const std::filesystem::path& path, const Picture& picture, const PngForm& form,
              const Settings& settings);

enum class ExrDepth { half, full };

// Channels of an EXR beside R, G and B, one number a pixel each; always 32-bit floats.
struct ExrLayer {
    std::string channel;        // "depth.Z"
    std::vector<float> numbers; // width * height, rows from the bottom up
};

// Writes the R, G, B channels of a float32 picture and the layers, ZIP-compressed. Throws cannotWrite.
void writeExr(const std::filesystem::path& path, const Picture& picture, ExrDepth depth,
              const Settings& settings, const std::vector<ExrLayer>& layers = {});

// Writes the R, G, B of a float32 picture as Radiance RGBE: 8 bits under an exponent that they share, rounded
// to nearest. What it cannot hold: negative numbers and NaN become 0, numbers beyond 1.69e38 that number.
// Throws cannotWrite.
void writeRadiance(const std::filesystem::path& path, const Picture& picture, const Settings& settings);

// What the writers put into a file as text; a Radiance picture has spaces where there were line breaks. Empty
// for files of other kinds, and where it cannot be read.
Settings readSettings(const std::filesystem::path& path);

} // namespace dioptre
