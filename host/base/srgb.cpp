#include "base/srgb.h"

#include "base/picture.h"

#include <array>
#include <bit>
#include <cmath>

namespace dioptre
{
namespace
{

// What the table below must reproduce for every float.
int srgb8ByDefinition(float linear)
{
    return static_cast<int>(std::floor(srgbFromLinear(linear) * 255.0 + 0.5));
}

// The smallest float whose code is `code`: bisection over the bits, which are ordered as positive floats are.
float firstLinearOfCode(int code)
{
    std::uint32_t below = 0; // 0.0f has code 0
    std::uint32_t reached = std::bit_cast<std::uint32_t>(1.0f);
    while (reached - below > 1) {
        const std::uint32_t middle = below + (reached - below) / 2;
        (srgb8ByDefinition(std::bit_cast<float>(middle)) < code ? below : reached) = middle;
    }
    return std::bit_cast<float>(reached);
}

// Floats below 2^-13 have code 0. From there to 1 every octave has 128 cells, narrow enough (at most 0.0039
// near 1, where codes are 0.0060 apart or more) that at most one code begins inside a cell.
constexpr int cellBits = 23 - 7;
constexpr std::uint32_t firstCell = std::bit_cast<std::uint32_t>(0x1p-13f) >> cellBits;
constexpr std::size_t cellCount = (std::bit_cast<std::uint32_t>(1.0f) >> cellBits) - firstCell;

struct Cell {
    float nextBegins; // linear value from which the code is one more
    int code;         // of the cell's lowest value
};

std::array<Cell, cellCount> makeCells()
{
    std::array<float, 257> begins{};
    for (int code = 1; code < 256; ++code)
        begins[static_cast<std::size_t>(code)] = firstLinearOfCode(code);
    begins[256] = 2.0f; // never reached
    std::array<Cell, cellCount> cells{};
    std::size_t code = 0;
    for (std::size_t i = 0; i < cellCount; ++i) {
        const auto lowest = std::bit_cast<float>((firstCell + static_cast<std::uint32_t>(i)) << cellBits);
        while (begins[code + 1] <= lowest)
            ++code;
        cells[i] = {begins[code + 1], static_cast<int>(code)};
    }
    return cells;
}

std::array<float, 256> makeDecoded()
{
    std::array<float, 256> decoded{};
    for (std::size_t code = 0; code < decoded.size(); ++code)
        decoded[code] = static_cast<float>(linearFromSrgb(static_cast<double>(code) / 255.0));
    return decoded;
}

} // namespace

double linearFromSrgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::uint8_t byteFromUnit(float value)
{
    if (!(value > 0.0f))
        return 0;
    return value >= 1.0f ? std::uint8_t{255} : static_cast<std::uint8_t>(value * 255.0f + 0.5f);
}

// Exact and some ten times faster than std::pow: one cell gives the code but for a comparison.
std::uint8_t srgb8FromLinear(float linear)
{
    static const std::array<Cell, cellCount> cells = makeCells();
    if (!(linear >= 0x1p-13f))
        return 0;
    if (linear >= 1.0f)
        return 255;
    const Cell& cell = cells[(std::bit_cast<std::uint32_t>(linear) >> cellBits) - firstCell];
    return static_cast<std::uint8_t>(cell.code + (linear >= cell.nextBegins ? 1 : 0));
}

float linearFromSrgb8(std::uint8_t encoded)
{
    static const std::array<float, 256> decoded = makeDecoded();
    return decoded[encoded];
}

} // namespace dioptre
