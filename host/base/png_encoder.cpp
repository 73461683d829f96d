#include "base/png_encoder.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// Runs alone (zlib's Z_RLE) after the horizontal filter: on renders and photographs as small as level 1's
// search or smaller, in two thirds to nine tenths of its time.
constexpr int fastestDeflate = 1;
constexpr int runLengthStrategy = 3;

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

// Faults of the file are found by its own check, which has the better words.
int writeOn(spng_ctx*, void* file, void* bytes, std::size_t count)
{
    static_cast<CheckedFile*>(file)->write(static_cast<const char*>(bytes), count);
    return 0;
}

} // namespace

PngEncoder::PngEncoder(const std::filesystem::path& path, const PngHead& head, const Settings& settings)
    : path_(path), file_(path), context_(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free)
{
    check(spng_set_png_stream(context_.get(), &writeOn, &file_));
    // Fast before small: the default deflate level takes longer than the render.
    check(spng_set_option(context_.get(), SPNG_IMG_COMPRESSION_LEVEL, fastestDeflate));
    check(spng_set_option(context_.get(), SPNG_IMG_COMPRESSION_STRATEGY, runLengthStrategy));
    check(spng_set_option(context_.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB));
    begin(head, settings);
}

void PngEncoder::begin(const PngHead& head, const Settings& settings)
{
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(head.width);
    header.height = static_cast<std::uint32_t>(head.height);
    header.bit_depth = static_cast<std::uint8_t>(head.bits);
    header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
    check(spng_set_ihdr(context_.get(), &header));
    if (head.gamma_100000ths)
        check(spng_set_gama_int(context_.get(), *head.gamma_100000ths));
    std::vector<spng_text> chunks = textChunks(settings);
    if (!chunks.empty())
        check(spng_set_text(context_.get(), chunks.data(), static_cast<std::uint32_t>(chunks.size())));
    // Writes all chunks before the pixels.
    check(spng_encode_image(context_.get(), nullptr, 0, SPNG_FMT_PNG,
                            SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE));
}

void PngEncoder::add(const void* codes, std::size_t size_bytes)
{
    const int outcome = spng_encode_row(context_.get(), codes, size_bytes);
    check(outcome == SPNG_EOI ? 0 : outcome); // SPNG_EOI: that was the last row, and the end is written
}

void PngEncoder::finish()
{
    file_.finish();
}

void PngEncoder::check(int outcome) const
{
    file_.check();
    if (outcome != 0)
        fail(ExitCode::cannotWrite, {path_.string()}, fmt::format("PNG: {}", spng_strerror(outcome)),
             "choose another format or other settings");
}

} // namespace dioptre
