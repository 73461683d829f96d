// Bytes as a picture of the kind that they say they are: its pixels and its settings.
#include "fuzz.h"

#include "base/picture.h"

#include <zlib.h>

using namespace dioptre;

namespace
{

std::uint32_t bigEndianAt(const std::string& bytes, std::size_t at)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return number;
}

// Puts the right checksum behind each chunk of a PNG: hardly any change would get past a wrong one.
void mendChecksums(std::string& bytes)
{
    constexpr std::size_t signature = 8, besides = 12; // a chunk is length, type, content, checksum
    if (!bytes.starts_with("\x89PNG"))
        return;
    for (std::size_t at = signature; at + besides <= bytes.size();) {
        const std::size_t length = bigEndianAt(bytes, at);
        if (length > bytes.size() - at - besides)
            return;
        const auto* checked = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
        const auto sum = static_cast<std::uint32_t>(crc32(0, checked, static_cast<uInt>(4 + length)));
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i));
        at += besides + length;
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::filesystem::path folder = fuzz::emptyFolder();
    std::string bytes = fuzz::textOf(data, size);
    mendChecksums(bytes);
    const std::filesystem::path path = folder / "picture";
    fuzz::write(path, bytes);
    fuzz::succeeds([&] {
        const Picture picture = readPicture(path);
        const std::size_t numbers =
            4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
        fuzz::demand(numbers > 0 && picture.bytes.size() + picture.floats.size() == numbers);
    });
    readSettings(path); // it never throws
    return 0;
}
