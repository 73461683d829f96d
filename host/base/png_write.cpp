#include "base/picture_writer.h"
#include "base/png_encoder.h"
#include "base/srgb.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// 0..1 as the file holds it, before it is scaled to whole numbers; the clamping makes NaN 0.
double transferred(float value, const PngForm& form)
{
    const double unit = value > 0.0F ? std::min(static_cast<double>(value), 1.0) : 0.0;
    if (!form.encode)
        return unit;
    return form.gamma ? std::pow(unit, 1.0 / *form.gamma) : srgbFromLinear(unit);
}

// R, G, B of each texel of a row; `codeOf` makes a code of one of `numbers`.
template <typename Code, typename Number, typename CodeOf>
void encodeRow(const Picture& picture, const std::vector<Number>& numbers, std::size_t row, Code* codes,
               CodeOf codeOf)
{
    const auto width = static_cast<std::size_t>(picture.width);
    const Number* texel = numbers.data() + 4 * row * width;
    for (std::size_t x = 0; x < width; ++x, texel += 4) {
        *codes++ = codeOf(texel[0]);
        *codes++ = codeOf(texel[1]);
        *codes++ = codeOf(texel[2]);
    }
}

void encodeRow8(const Picture& picture, const PngForm& form, std::size_t row, std::uint8_t* codes)
{
    if (picture.format != PixelFormat::float32)
        return encodeRow(picture, picture.bytes, row, codes, [](std::uint8_t byte) { return byte; });
    if (form.encode && form.gamma)
        return encodeRow(picture, picture.floats, row, codes, [&form](float value) {
            return static_cast<std::uint8_t>(255.0 * transferred(value, form) + 0.5);
        });
    encodeRow(picture, picture.floats, row, codes, form.encode ? srgb8FromLinear : byteFromUnit);
}

void encodeRow16(const Picture& picture, const PngForm& form, std::size_t row, std::uint16_t* codes)
{
    encodeRow(picture, picture.floats, row, codes, [&form](float value) {
        return static_cast<std::uint16_t>(65535.0 * transferred(value, form) + 0.5);
    });
}

PngHead headOf(int width, int height, const PngForm& form)
{
    PngHead head{width, height, form.bits, {}};
    if (form.encode && form.gamma)
        head.gamma_100000ths = static_cast<std::uint32_t>(std::lround(100000.0 / *form.gamma));
    return head;
}

class PngWriter : public PictureWriter
{
public:
    PngWriter(const std::filesystem::path& path, int width, int height, const PngForm& form,
              const Settings& settings)
        : form_(form), encoder_(path, headOf(width, height, form), settings)
    {
    }

    void add(const Picture& band, const std::vector<ExrLayer>&) override
    {
        const std::size_t count = 3 * static_cast<std::size_t>(band.width);
        std::vector<std::uint8_t> codes8(form_.bits == 16 ? 0 : count);
        std::vector<std::uint16_t> codes16(form_.bits == 16 ? count : 0);
        for (auto row = static_cast<std::size_t>(band.height); row-- > 0;) {
            if (form_.bits == 16) {
                encodeRow16(band, form_, row, codes16.data());
                encoder_.add(codes16.data(), count * sizeof(std::uint16_t));
            } else {
                encodeRow8(band, form_, row, codes8.data());
                encoder_.add(codes8.data(), count);
            }
        }
    }

    void finish() override
    {
        encoder_.finish();
    }

private:
    PngForm form_;
    PngEncoder encoder_;
};

} // namespace

std::vector<std::uint8_t> topDownBytes(const Picture& picture, const PngForm& form)
{
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    std::vector<std::uint8_t> codes(3 * width * height);
    for (std::size_t row = 0; row < height; ++row)
        encodeRow8(picture, form, height - 1 - row, codes.data() + 3 * row * width);
    return codes;
}

std::unique_ptr<PictureWriter> openPng(const std::filesystem::path& path, int width, int height,
                                       const PngForm& form, const Settings& settings)
{
    return std::make_unique<PngWriter>(path, width, height, form, settings);
}

void writePng(const std::filesystem::path& path, const Picture& picture, const PngForm& form,
              const Settings& settings)
{
    PngWriter writer(path, picture.width, picture.height, form, settings);
    writer.add(picture, {});
    writer.finish();
}

} // namespace dioptre
