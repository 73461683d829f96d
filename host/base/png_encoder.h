// The file of a PNG, row by row.
#pragma once

#include "base/checked_file.h"
#include "base/picture.h"

#include <spng.h>

#include <memory>
#include <string_view>

namespace dioptre
{

// What the head of an RGB PNG says.
struct PngHead {
    int width = 0;                                  // pixels
    int height = 0;                                 // pixels
    int bits = 8;                                   // a channel: 8 or 16
    std::optional<std::uint32_t> gamma_100000ths{}; // gAMA, left out where unset
};

class PngEncoder
{
public:
    PngEncoder(const std::filesystem::path& path, const PngHead& head, const Settings& settings);

    // The next row below: R, G, B of each pixel; codes of 16 bits in the order of the machine.
    void add(const void* codes, std::size_t size_bytes);

    // After the last row. Throws cannotWrite.
    void finish();

private:
    void begin(const PngHead& head, const Settings& settings);
    void check(int outcome) const;

    std::filesystem::path path_;
    CheckedFile file_;
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
};

} // namespace dioptre
