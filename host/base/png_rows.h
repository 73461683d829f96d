// A PNG read row by row, so that no more than a few rows of it are in memory.
#pragma once

#include "base/png_encoder.h"

#include <fstream>

namespace dioptre
{

class PngRows
{
public:
    // Throws inputMissing. The others throw badInput for what is broken or cut short.
    explicit PngRows(const std::filesystem::path& path);

    // Throws badInput too for what PngEncoder does not write: palettes, alpha, interlacing and the like.
    PngHead head();

    // The chunks of text before the pixels.
    Settings settings();

    // All rows from the top down, one a call: R, G, B of each pixel as in PngEncoder; then the end.
    void begin();
    void next(void* codes, std::size_t size_bytes);
    void end();

private:
    void check(int outcome) const;

    std::filesystem::path path_;
    std::ifstream in_;
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
};

} // namespace dioptre
