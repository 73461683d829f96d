#include "support/compare.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dioptre::test
{
namespace
{

template <typename Value>
Difference compareBy(const Picture& actual, const Picture& expected, double threshold, const Value& value)
{
    if (actual.width != expected.width || actual.height != expected.height ||
        actual.floats.size() != expected.floats.size() || actual.floats.empty())
        throw std::invalid_argument("pictures of different sizes or formats");
    Difference difference;
    difference.pixels = actual.floats.size() / 4;
    for (std::size_t pixel = 0; pixel < difference.pixels; ++pixel) {
        double worst = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double off =
                std::abs(value(actual.floats[4 * pixel + c]) - value(expected.floats[4 * pixel + c]));
            difference.rmse += off * off;
            // A NaN must not pass as "no difference".
            worst = std::isnan(off) ? HUGE_VAL : std::max(worst, off);
        }
        difference.largest = std::max(difference.largest, worst);
        difference.over += worst > threshold ? 1 : 0;
    }
    difference.rmse = std::sqrt(difference.rmse / (3.0 * static_cast<double>(difference.pixels)));
    return difference;
}

} // namespace

Difference compare(const Picture& actual, const Picture& expected, double threshold)
{
    return compareBy(actual, expected, threshold, [](float v) { return static_cast<double>(v); });
}

Difference compareEncoded(const Picture& actual, const Picture& expected, double threshold)
{
    return compareBy(actual, expected, threshold,
                     [](float v) { return static_cast<double>(srgb8FromLinear(v)); });
}

std::string saveForTheEye(const std::string& name, const Picture& actual, const Picture& expected)
{
    const std::filesystem::path folder = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "tests" / "output";
    std::filesystem::create_directories(folder);
    Picture difference = actual;
    for (std::size_t i = 0; i < std::min(actual.floats.size(), expected.floats.size()); ++i)
        difference.floats[i] = std::abs(actual.floats[i] - expected.floats[i]);
    writeExr(folder / (name + "-actual.exr"), actual, ExrDepth::full, {});
    writeExr(folder / (name + "-expected.exr"), expected, ExrDepth::full, {});
    writeExr(folder / (name + "-difference.exr"), difference, ExrDepth::full, {});
    return "see " + (folder / name).string() + "-{actual,expected,difference}.exr";
}

Picture decoded(const Picture& picture)
{
    if (picture.format == PixelFormat::float32)
        return picture;
    Picture result{picture.width, picture.height, PixelFormat::float32, {}, {}};
    for (std::size_t i = 0; i < picture.bytes.size(); ++i)
        result.floats.push_back(picture.format == PixelFormat::srgb8 && i % 4 < 3
                                    ? linearFromSrgb8(picture.bytes[i])
                                    : static_cast<float>(picture.bytes[i]) / 255.0F);
    return result;
}

} // namespace dioptre::test
