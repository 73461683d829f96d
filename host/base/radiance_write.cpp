#include "base/checked_file.h"
#include "base/error.h"
#include "base/picture_writer.h"
#include "base/radiance_head.h"

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

// Rows [first, end) of a band, from the upper to the lower, as they stand in a file.
std::string encodeRows(const Picture& band, std::size_t first, std::size_t end)
{
    const auto width = static_cast<std::size_t>(band.width);
    std::vector<float> numbers;
    numbers.reserve(3 * width * (end - first));
    for (std::size_t row = end; row-- > first;)
        for (std::size_t x = 0; x < width; ++x) {
            const auto rgbe = nearestRgbe(&band.floats[4 * (row * width + x)]);
            numbers.insert(numbers.end(), rgbe.begin(), rgbe.end());
        }
    std::string bytes;
    stbi_write_hdr_to_func(appendTo, &bytes, band.width, static_cast<int>(end - first), 3, numbers.data());
    // Without stb's text.
    return bytes.substr(bytes.find('\n', bytes.find("\n\n") + 2) + 1);
}

// stb writes whole pictures. Here each few rows are one, and what stands above them is ours.
class RadianceWriter : public PictureWriter
{
public:
    RadianceWriter(const std::filesystem::path& path, int width, int height, const Settings& settings)
        : file_(path)
    {
        if (width < 1 || height < 1)
            fail(ExitCode::cannotWrite, {path.string()}, "Radiance: the picture is empty",
                 "choose another format");
        write(radianceText({width, height, settings}));
    }

    void add(const Picture& band, const std::vector<ExrLayer>&) override
    {
        constexpr std::size_t rowsAtOnce = 64;
        for (auto end = static_cast<std::size_t>(band.height); end > 0;) {
            const std::size_t first = end - std::min(end, rowsAtOnce);
            write(encodeRows(band, first, end));
            end = first;
        }
        file_.check();
    }

    void finish() override
    {
        file_.finish();
    }

private:
    void write(const std::string& bytes)
    {
        file_.write(bytes.data(), bytes.size());
    }

    CheckedFile file_;
};

} // namespace

std::unique_ptr<PictureWriter> openRadiance(const std::filesystem::path& path, int width, int height,
                                            const Settings& settings)
{
    return std::make_unique<RadianceWriter>(path, width, height, settings);
}

void writeRadiance(const std::filesystem::path& path, const Picture& picture, const Settings& settings)
{
    RadianceWriter writer(path, picture.width, picture.height, settings);
    writer.add(picture, {});
    writer.finish();
}

} // namespace dioptre
