#include "base/picture_codecs.h"
#include "base/srgb.h"

#include <spng.h>

#include <memory>

namespace dioptre
{
namespace
{

// libspng and not stb: it checks the checksums, tells gAMA, and reports a file that was cut short.
class PngReader
{
public:
    PngReader(const std::filesystem::path& path, const std::string& bytes)
        : path_(path), context_(spng_ctx_new(0), &spng_ctx_free)
    {
        check(spng_set_chunk_limits(context_.get(), mostBesidePixels, mostBesidePixels));
        check(spng_set_png_buffer(context_.get(), bytes.data(), bytes.size()));
    }

    spng_ihdr header() const
    {
        spng_ihdr header{};
        check(spng_get_ihdr(context_.get(), &header));
        return header;
    }

    // Whether the file says that its numbers are linear: a gAMA chunk of 1.0.
    bool saysLinear() const
    {
        std::uint32_t hundredThousandths = 0;
        const int outcome = spng_get_gama_int(context_.get(), &hundredThousandths);
        if (outcome != SPNG_ECHUNKAVAIL)
            check(outcome);
        return outcome == 0 && hundredThousandths == 100000;
    }

    void decode(void* numbers, std::size_t size, spng_format format) const
    {
        check(spng_decode_image(context_.get(), numbers, size, format, SPNG_DECODE_TRNS));
        check(spng_decode_chunks(context_.get()));
    }

private:
    void check(int outcome) const
    {
        if (outcome != 0)
            failBroken(path_, spng_strerror(outcome));
    }

    const std::filesystem::path& path_;
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
};

// 16 bits do not fit a byte, so such pictures become linear floats.
void linearise(const std::vector<std::uint16_t>& encoded, bool linear, std::vector<float>& floats)
{
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        const double value = encoded[i] / 65535.0;
        const bool isCurved = !linear && i % 4 < 3;
        floats[i] = static_cast<float>(isCurved ? linearFromSrgb(value) : value);
    }
}

// Deflate packs at best 1032 bytes into one.
void checkHeader(const std::filesystem::path& path, const spng_ihdr& header, std::uintmax_t fileBytes)
{
    checkSize(path, header.width, header.height);
    const std::uintmax_t channels = header.color_type == SPNG_COLOR_TYPE_TRUECOLOR         ? 3
                                    : header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA ? 4
                                    : header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ? 2
                                                                                           : 1;
    checkHolds(path, fileBytes, channels * header.bit_depth * header.width / 8 * header.height / 1032);
}

} // namespace

Picture decodePng(const std::filesystem::path& path, const std::string& bytes, Encoding encoding)
{
    const PngReader reader(path, bytes);
    const spng_ihdr header = reader.header();
    checkHeader(path, header, bytes.size());
    const bool linear =
        encoding == Encoding::linear || (encoding == Encoding::automatic && reader.saysLinear());
    const bool deep = header.bit_depth == 16;
    const PixelFormat format = deep     ? PixelFormat::float32
                               : linear ? PixelFormat::linear8
                                        : PixelFormat::srgb8;
    Picture picture = blankPicture(path, header.width, header.height, format);
    if (deep) {
        std::vector<std::uint16_t> encoded(picture.floats.size());
        reader.decode(encoded.data(), encoded.size() * sizeof(std::uint16_t), SPNG_FMT_RGBA16);
        linearise(encoded, linear, picture.floats);
    } else {
        reader.decode(picture.bytes.data(), picture.bytes.size(), SPNG_FMT_RGBA8);
    }
    flipRows(picture);
    return picture;
}

} // namespace dioptre
