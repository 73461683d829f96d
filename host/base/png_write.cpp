#include "base/error.h"
#include "base/picture.h"
#include "base/srgb.h"
#include "base/write_file.h"

#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace dioptre
{
namespace
{

// Runs alone (zlib's Z_RLE) after the horizontal filter: on renders and photographs as small as level 1's
// search or smaller, in two thirds to nine tenths of its time.
constexpr int fastestDeflate = 1;
constexpr int runLengthStrategy = 3;

// R, G, B of each texel, from the top down; `codeOf` makes a code of one of `numbers`.
template <typename Code, typename Number, typename CodeOf>
std::vector<Code> topDownRgb(const Picture& picture, const std::vector<Number>& numbers, CodeOf codeOf)
{
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    std::vector<Code> codes(3 * width * height);
    Code* next = codes.data();
    for (std::size_t row = height; row-- > 0;) {
        const Number* texel = numbers.data() + 4 * row * width;
        for (std::size_t x = 0; x < width; ++x, texel += 4) {
            *next++ = codeOf(texel[0]);
            *next++ = codeOf(texel[1]);
            *next++ = codeOf(texel[2]);
        }
    }
    return codes;
}

// 0..1 as the file holds it, before it is scaled to whole numbers; the clamping makes NaN 0.
double transferred(float value, const PngForm& form)
{
    const double unit = value > 0.0F ? std::min(static_cast<double>(value), 1.0) : 0.0;
    if (!form.encode)
        return unit;
    return form.gamma ? std::pow(unit, 1.0 / *form.gamma) : srgbFromLinear(unit);
}

std::vector<std::uint8_t> codes8(const Picture& picture, const PngForm& form)
{
    if (picture.format != PixelFormat::float32)
        return topDownRgb<std::uint8_t>(picture, picture.bytes, [](std::uint8_t byte) { return byte; });
    if (form.encode && form.gamma)
        return topDownRgb<std::uint8_t>(picture, picture.floats, [&form](float value) {
            return static_cast<std::uint8_t>(255.0 * transferred(value, form) + 0.5);
        });
    return topDownRgb<std::uint8_t>(picture, picture.floats, form.encode ? srgb8FromLinear : byteFromUnit);
}

std::vector<std::uint16_t> codes16(const Picture& picture, const PngForm& form)
{
    return topDownRgb<std::uint16_t>(picture, picture.floats, [&form](float value) {
        return static_cast<std::uint16_t>(65535.0 * transferred(value, form) + 0.5);
    });
}

// tEXt holds Latin-1, so text beyond ASCII (it is UTF-8) goes into iTXt. Empty values are left out: libspng
// refuses them.
std::vector<spng_text> textChunks(const Settings& settings)
{
    std::vector<spng_text> chunks;
    for (const auto& [key, value] : settings) {
        if (value.empty())
            continue;
        spng_text chunk{};
        std::copy_n(key.begin(), std::min(key.size(), sizeof(chunk.keyword) - 1), chunk.keyword);
        const bool isAscii = std::all_of(value.begin(), value.end(), [](char letter) { return letter > 0; });
        chunk.type = isAscii ? SPNG_TEXT : SPNG_ITXT;
        chunk.text = const_cast<char*>(value.c_str()); // libspng only reads it
        chunk.length = value.size();
        chunk.language_tag = const_cast<char*>("");
        chunk.translated_keyword = const_cast<char*>("");
        chunks.push_back(chunk);
    }
    return chunks;
}

class PngWriter
{
public:
    explicit PngWriter(const std::filesystem::path& path)
        : path_(path), context_(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free)
    {
        set(SPNG_ENCODE_TO_BUFFER, 1);
    }

    void set(spng_option option, int value)
    {
        check(spng_set_option(context_.get(), option, value));
    }

    void describe(const Picture& picture, const PngForm& form, std::vector<spng_text> chunks)
    {
        spng_ihdr header{};
        header.width = static_cast<std::uint32_t>(picture.width);
        header.height = static_cast<std::uint32_t>(picture.height);
        header.bit_depth = static_cast<std::uint8_t>(form.bits);
        header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
        check(spng_set_ihdr(context_.get(), &header));
        if (form.encode && form.gamma)
            check(spng_set_gama_int(context_.get(),
                                    static_cast<std::uint32_t>(std::lround(100000.0 / *form.gamma))));
        if (!chunks.empty())
            check(spng_set_text(context_.get(), chunks.data(), static_cast<std::uint32_t>(chunks.size())));
    }

    // Codes of 16 bits are in the order of the machine; libspng turns them.
    template <typename Code>
    std::string encode(const std::vector<Code>& rgb)
    {
        check(spng_encode_image(context_.get(), rgb.data(), rgb.size() * sizeof(Code), SPNG_FMT_PNG,
                                SPNG_ENCODE_FINALIZE));
        int outcome = 0;
        std::size_t size = 0;
        const std::unique_ptr<void, void (*)(void*)> buffer(
            spng_get_png_buffer(context_.get(), &size, &outcome), &std::free);
        check(outcome);
        return {static_cast<const char*>(buffer.get()), size};
    }

private:
    void check(int outcome) const
    {
        if (outcome != 0)
            fail(ExitCode::cannotWrite, {path_.string()}, fmt::format("PNG: {}", spng_strerror(outcome)),
                 "choose another format or other settings");
    }

    const std::filesystem::path& path_;
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
};

} // namespace

std::vector<std::uint8_t> topDownBytes(const Picture& picture, const PngForm& form)
{
    return codes8(picture, form);
}

// Fast before small: the default deflate level takes longer than the render.
void writePng(const std::filesystem::path& path, const Picture& picture, const PngForm& form,
              const Settings& settings)
{
    PngWriter writer(path);
    writer.set(SPNG_IMG_COMPRESSION_LEVEL, fastestDeflate);
    writer.set(SPNG_IMG_COMPRESSION_STRATEGY, runLengthStrategy);
    writer.set(SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB);
    writer.describe(picture, form, textChunks(settings));
    writeFile(path,
              form.bits == 16 ? writer.encode(codes16(picture, form)) : writer.encode(codes8(picture, form)));
}

} // namespace dioptre
