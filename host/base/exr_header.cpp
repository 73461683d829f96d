#include "base/exr_header.h"

#include "base/picture_codecs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dioptre
{
namespace
{

constexpr std::size_t longestName = 255;

constexpr int densest = 8; // DWAA

// At most so many numbers come of a byte of a file of that compression. Deflate packs 1032 bytes into one, no
// less than one number (PXR24: of three bytes); Huffman codes of runs and B44's blocks hold less. DWA packs
// 64 bytes, or as many halves into four, before it deflates them.
double mostNumbersOfAByte(int compression)
{
    constexpr int none = 0;
    constexpr double deflate = 1032.0, halfBytes = 2.0;
    return compression == none ? 1.0 : compression < densest ? deflate : 64.0 * deflate / halfBytes;
}

// Bytes of the types that are of one size: OpenEXR reads so many of them, whatever an attribute's size says.
const std::map<std::string_view, std::int64_t>& fixedSizes()
{
    static const std::map<std::string_view, std::int64_t> sizes{{"box2f", 16},
                                                                {"box2i", 16},
                                                                {"chromaticities", 32},
                                                                {"compression", 1},
                                                                {"deepImageState", 1},
                                                                {"double", 8},
                                                                {"envmap", 1},
                                                                {"float", 4},
                                                                {"int", 4},
                                                                {"keycode", 28},
                                                                {"lineOrder", 1},
                                                                {"m33d", 72},
                                                                {"m33f", 36},
                                                                {"m44d", 128},
                                                                {"m44f", 64},
                                                                {"rational", 8},
                                                                {"tiledesc", 9},
                                                                {"timecode", 8},
                                                                {"v2d", 16},
                                                                {"v2f", 8},
                                                                {"v2i", 8},
                                                                {"v3d", 24},
                                                                {"v3f", 12},
                                                                {"v3i", 12}};
    return sizes;
}

// https://openexr.com/en/latest/OpenEXRFileLayout.html: attributes, each a name, a type, a size and that many
// bytes, numbers in little-endian order; an empty name ends a header.
class ExrHeaders
{
public:
    ExrHeaders(const std::filesystem::path& path, Imf::IStream& stream, std::uintmax_t bytes,
               ExrReading reading)
        : path_(path), stream_(stream), bytes_(bytes), reading_(reading)
    {
    }

    void check()
    {
        constexpr std::uint64_t versionAt = 4;
        stream_.seekg(versionAt);
        constexpr std::int64_t manyParts = 0x1000;
        const bool several = (nextInt() & manyParts) != 0;
        while (checkNext() && several) { // an empty header ends those of several parts
        }
        stream_.seekg(0);
    }

private:
    struct Claims {
        std::int64_t width = 0, height = 0;
        std::int64_t tileWidth = 0, tileHeight = 0; // 0: none
        int compression = 0;
        std::vector<std::pair<std::int64_t, std::int64_t>>
            samplings; // of channels: a number each x texels, y rows
    };

    // Whether there was an attribute in it.
    bool checkNext()
    {
        Claims claims;
        bool any = false;
        for (std::string name = nextName(); !name.empty(); name = nextName()) {
            any = true;
            const std::string type = nextName();
            const std::int64_t size = nextInt();
            const std::uint64_t value = stream_.tellg();
            if (size < 0 || static_cast<std::uint64_t>(size) > bytes_ - value)
                failBroken(path_, "its attribute " + name + " is longer than the file");
            const auto fixed = fixedSizes().find(type);
            if (fixed != fixedSizes().end() && size != fixed->second)
                failBroken(path_, "its attribute " + name + " is of another size than " + type);
            read(claims, name, type);
            const std::uint64_t end = value + static_cast<std::uint64_t>(size);
            if (type == "chlist" && stream_.tellg() != end)
                failBroken(path_, "its channels end elsewhere than they say");
            stream_.seekg(end);
        }
        if (claims.tileWidth > 0)
            checkChunks(((claims.width + claims.tileWidth - 1) / claims.tileWidth) *
                        ((claims.height + claims.tileHeight - 1) / claims.tileHeight));
        checkNumbers(claims);
        return any;
    }

    void read(Claims& claims, const std::string& name, const std::string& type)
    {
        if (type == "box2i" && (name == "dataWindow" || name == "displayWindow")) {
            const std::int64_t left = nextInt(), top = nextInt();
            const std::int64_t columns = nextInt() - left + 1, rows = nextInt() - top + 1;
            checkWindow(columns, rows);
            if (name == "dataWindow") {
                claims.width = columns;
                claims.height = rows;
            }
        } else if (type == "tiledesc") {
            claims.tileWidth = std::max<std::int64_t>(nextInt(), 1);
            claims.tileHeight = std::max<std::int64_t>(nextInt(), 1);
        } else if (name == "chunkCount" && type == "int") {
            checkChunks(nextInt());
        } else if (type == "compression") {
            claims.compression = nextByte();
        } else if (type == "chlist") {
            claims.samplings.clear();
            while (!nextName().empty()) {
                nextInt(); // the type of number
                nextInt(); // how it is seen, and nothing
                const std::int64_t x = nextInt(), y = nextInt();
                claims.samplings.emplace_back(std::max<std::int64_t>(x, 1), std::max<std::int64_t>(y, 1));
            }
        }
    }

    void checkWindow(std::int64_t columns, std::int64_t rows) const
    {
        if (reading_ == ExrReading::picture)
            checkSize(path_, columns, rows);
        else if (columns < 1 || rows < 1)
            failBroken(path_, fmt::format("its size is {}x{}", columns, rows));
    }

    // The file lists a place of 8 bytes for each.
    void checkChunks(std::int64_t count) const
    {
        if (count < 0 || static_cast<std::uint64_t>(count) > bytes_ / 8)
            failBroken(path_, "it claims more chunks than it could list");
    }

    void checkNumbers(const Claims& claims) const
    {
        const auto atLeast = [&](std::int64_t width, std::int64_t height, int compression) {
            double numbers = 0.0;
            for (const auto& [x, y] : claims.samplings)
                numbers += static_cast<double>(width / x) * static_cast<double>(height / y);
            // More than 2^62 are too many in any case, and more than 2^64 are no whole number here.
            return static_cast<std::uintmax_t>(std::min(numbers / mostNumbersOfAByte(compression), 0x1p62));
        };
        checkHolds(path_, bytes_, atLeast(claims.width, claims.height, claims.compression));
        // What of a tile is outside the window takes no bytes, but OpenEXR takes memory for it: as little as
        // any compression would need is asked for.
        checkHolds(path_, bytes_, atLeast(claims.tileWidth, claims.tileHeight, densest));
    }

    std::uint8_t nextByte()
    {
        char byte = 0;
        if (stream_.tellg() >= bytes_)
            failBroken(path_, "its header does not end");
        stream_.read(&byte, 1);
        return static_cast<std::uint8_t>(byte);
    }

    std::string nextName()
    {
        std::string name;
        for (char letter = static_cast<char>(nextByte()); letter != '\0';
             letter = static_cast<char>(nextByte())) {
            name += letter;
            if (name.size() > longestName)
                failBroken(path_, "a name in its header does not end");
        }
        return name;
    }

    std::int64_t nextInt()
    {
        std::uint32_t number = 0;
        for (int shift = 0; shift < 32; shift += 8)
            number |= std::uint32_t{nextByte()} << shift;
        return static_cast<std::int32_t>(number);
    }

    const std::filesystem::path& path_;
    Imf::IStream& stream_;
    std::uintmax_t bytes_;
    ExrReading reading_;
};

Imf::IStream& checked(const std::filesystem::path& path, Imf::IStream& stream)
{
    checkExrHeaders(path, stream, std::filesystem::file_size(path), ExrReading::parts);
    return stream;
}

} // namespace

void checkExrHeaders(const std::filesystem::path& path, Imf::IStream& stream, std::uintmax_t bytes,
                     ExrReading reading)
{
    ExrHeaders(path, stream, bytes, reading).check();
}

ExrInput::ExrInput(const std::filesystem::path& path) : stream(path.c_str()), file(checked(path, stream)) {}

} // namespace dioptre
