#include "base/png_rows.h"

#include "base/error.h"
#include "base/picture_codecs.h"

namespace dioptre
{
namespace
{

int readFrom(spng_ctx*, void* in, void* bytes, std::size_t count)
{
    auto& file = *static_cast<std::ifstream*>(in);
    file.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
    return file ? 0 : SPNG_IO_EOF;
}

} // namespace

PngRows::PngRows(const std::filesystem::path& path)
    : path_(path), in_(openFile(path)), context_(spng_ctx_new(0), &spng_ctx_free)
{
    check(spng_set_chunk_limits(context_.get(), mostBesidePixels, mostBesidePixels));
    check(spng_set_png_stream(context_.get(), &readFrom, &in_));
}

PngHead PngRows::head()
{
    spng_ihdr header{};
    check(spng_get_ihdr(context_.get(), &header));
    if (header.color_type != SPNG_COLOR_TYPE_TRUECOLOR || header.bit_depth < 8 ||
        header.interlace_method != SPNG_INTERLACE_NONE)
        fail(ExitCode::badInput, {path_.string()}, "is a PNG in another form than dioptre writes",
             "name the file as it was written");
    PngHead head{static_cast<int>(header.width), static_cast<int>(header.height), header.bit_depth, {}};
    std::uint32_t gamma = 0;
    const int outcome = spng_get_gama_int(context_.get(), &gamma);
    if (outcome == SPNG_ECHUNKAVAIL)
        return head;
    check(outcome);
    head.gamma_100000ths = gamma;
    return head;
}

Settings PngRows::settings()
{
    std::uint32_t count = 0;
    const int outcome = spng_get_text(context_.get(), nullptr, &count);
    if (outcome == SPNG_ECHUNKAVAIL)
        return {};
    check(outcome);
    std::vector<spng_text> chunks(count);
    check(spng_get_text(context_.get(), chunks.data(), &count));
    Settings settings;
    for (const auto& chunk : chunks)
        settings[chunk.keyword] = std::string(chunk.text, chunk.length);
    return settings;
}

void PngRows::begin()
{
    check(spng_decode_image(context_.get(), nullptr, 0, SPNG_FMT_PNG, SPNG_DECODE_PROGRESSIVE));
}

void PngRows::next(void* codes, std::size_t size_bytes)
{
    const int outcome = spng_decode_row(context_.get(), codes, size_bytes);
    check(outcome == SPNG_EOI ? 0 : outcome); // SPNG_EOI: that was the last row
}

void PngRows::end()
{
    check(spng_decode_chunks(context_.get()));
    // libspng does not ask for the last chunk's checksum.
    constexpr std::string_view lastChunk("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
    std::string last(lastChunk.size(), '\0');
    in_.seekg(-static_cast<std::streamoff>(last.size()), std::ios::end);
    in_.read(last.data(), static_cast<std::streamsize>(last.size()));
    if (last != lastChunk)
        failBroken(path_, "it does not end with its last chunk");
}

void PngRows::check(int outcome) const
{
    if (outcome != 0)
        failBroken(path_, spng_strerror(outcome));
}

} // namespace dioptre
