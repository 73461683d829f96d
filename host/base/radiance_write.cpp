#include "base/error.h"
#include "base/picture.h"
#include "base/write_file.h"

#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre
{
namespace
{

// 255/256 of 2^127: the largest mantissa under the largest exponent.
constexpr float largestNumber = 0x1.FEp126F;

// stb cuts mantissas off, and its conversion of what is below 0 or not finite is undefined. So it is given
// numbers that RGBE holds exactly: multiples of 2^-8 of the power of two above the largest of the three.
std::array<float, 3> nearestRgbe(const float* rgb)
{
    std::array<float, 3> numbers{};
    for (std::size_t c = 0; c < 3; ++c)
        numbers[c] = rgb[c] > 0.0F ? std::min(rgb[c], largestNumber) : 0.0F; // NaN is not above 0
    const float largest = std::ranges::max(numbers);
    int exponent = 0;
    const float share = std::frexp(largest, &exponent);
    if (share * 256.0F >= 255.5F) // rounds up to the next power of two
        ++exponent;
    for (float& number : numbers)
        number = std::ldexp(std::floor(std::ldexp(number, 8 - exponent) + 0.5F), exponent - 8);
    return numbers;
}

void append(void* text, void* bytes, int size)
{
    static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

// KEY=VALUE lines, as Radiance's own tools write them; a line break in a value would end the line.
std::string headerLines(const Settings& settings)
{
    std::string lines;
    for (const auto& [key, value] : settings) {
        std::string line = key + "=" + value;
        std::ranges::replace(line, '\n', ' ');
        lines += line + "\n";
    }
    return lines;
}

} // namespace

void writeRadiance(const std::filesystem::path& path, const Picture& picture, const Settings& settings)
{
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    std::vector<float> numbers;
    numbers.reserve(3 * width * height);
    for (std::size_t row = height; row-- > 0;)
        for (std::size_t x = 0; x < width; ++x) {
            const auto rgbe = nearestRgbe(&picture.floats[4 * (row * width + x)]);
            numbers.insert(numbers.end(), rgbe.begin(), rgbe.end());
        }
    std::string bytes;
    if (stbi_write_hdr_to_func(append, &bytes, picture.width, picture.height, 3, numbers.data()) == 0)
        fail(ExitCode::cannotWrite, {path.string()}, "Radiance: the picture is empty",
             "choose another format");
    bytes.insert(bytes.find('\n') + 1, headerLines(settings)); // after the first line, which names the format
    writeFile(path, bytes);
}

} // namespace dioptre
