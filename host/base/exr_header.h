// What an EXR's headers claim, checked before OpenEXR takes memory for it.
#pragma once

#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStdIO.h>

#include <cstdint>
#include <filesystem>

namespace dioptre
{

// What is to be read of an EXR: all at once, or parts of it, whatever its size.
enum class ExrReading { picture, parts };

// `stream` is a whole file of so many bytes that begins as an EXR does; it is read from its beginning, and
// left there. Throws badInput where a header does not end, an attribute is longer than the file, a window is
// larger than a picture may be, or there are more chunks or numbers than the file could hold.
void checkExrHeaders(const std::filesystem::path& path, Imf::IStream& stream, std::uintmax_t bytes,
                     ExrReading reading);

// A file that OpenEXR reads in parts, its headers checked.
struct ExrInput {
    // Throws as checkExrHeaders() does, and whatever OpenEXR throws.
    explicit ExrInput(const std::filesystem::path& path);

    Imf::StdIFStream stream;
    Imf::InputFile file;
};

} // namespace dioptre
