#include "base/picture_entry.h"

#include "base/error.h"
#include "base/file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <span>
#include <type_traits>

namespace dioptre
{
namespace
{

constexpr std::array<char, 16> magic{'d', 'i', 'o', 'p', 't', 'r', 'e', ' ',
                                     'l', 'e', 'v', 'e', 'l', 's', ' ', '1'};
constexpr std::size_t mostLevels = 16; // of 16384 texels on a side there are 15

struct Shape {
    std::int32_t width;
    std::int32_t height;
    std::int32_t format; // a PixelFormat
};

// The numbers of all levels follow. In the byte order of the machine that wrote it.
struct Header {
    std::array<char, 16> magic;
    std::uint64_t checksum; // of the key, the shapes and the numbers
    std::uint64_t levelCount;
    std::array<Shape, mostLevels> shapes;
};
static_assert(std::has_unique_object_representations_v<Header>); // no padding of unknown contents

// Finds damage, not malice. Four lanes, as one multiplication a word would wait for the one before.
class Checksum
{
public:
    void add(std::span<const std::byte> bytes)
    {
        std::array<std::uint64_t, 4> words{};
        for (; bytes.size() >= sizeof(words); bytes = bytes.subspan(sizeof(words))) {
            std::memcpy(words.data(), bytes.data(), sizeof(words));
            mix(words);
        }
        words = {};
        std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(words)).begin());
        mix(words);
    }

    std::uint64_t value() const
    {
        std::uint64_t all = 0;
        for (const auto lane : lanes_)
            all = (std::rotl(all, 23) ^ lane) * factor;
        return all;
    }

private:
    static constexpr std::uint64_t factor = 0x9E3779B97F4A7C15U; // odd, so that nothing is lost

    void mix(const std::array<std::uint64_t, 4>& words)
    {
        for (std::size_t i = 0; i < words.size(); ++i)
            lanes_[i] = std::rotl((lanes_[i] ^ words[i]) * factor, 29);
    }

    std::array<std::uint64_t, 4> lanes_{1, 2, 3, 4};
};

std::span<const std::byte> numbersOf(const Picture& level)
{
    return level.format == PixelFormat::float32 ? std::as_bytes(std::span(level.floats))
                                                : std::as_bytes(std::span(level.bytes));
}

std::span<std::byte> numbersOf(Picture& level)
{
    return level.format == PixelFormat::float32 ? std::as_writable_bytes(std::span(level.floats))
                                                : std::as_writable_bytes(std::span(level.bytes));
}

std::uint64_t checksumOf(const std::string& key, const Header& header, const std::vector<Picture>& levels)
{
    Checksum sum;
    sum.add(std::as_bytes(std::span(key)));
    sum.add(std::as_bytes(std::span(header.shapes)));
    for (const auto& level : levels)
        sum.add(numbersOf(level));
    return sum.value();
}

Header headerOf(const std::string& key, const std::vector<Picture>& levels)
{
    Header header{magic, 0, levels.size(), {}};
    for (std::size_t i = 0; i < levels.size(); ++i)
        header.shapes.at(i) = {levels[i].width, levels[i].height,
                               static_cast<std::int32_t>(levels[i].format)};
    header.checksum = checksumOf(key, header, levels);
    return header;
}

bool isSane(const Shape& shape)
{
    constexpr int longestSide = 16384; // as readPicture takes them
    return shape.width >= 1 && shape.width <= longestSide && shape.height >= 1 &&
           shape.height <= longestSide && shape.format >= 0 &&
           shape.format <= static_cast<int>(PixelFormat::float32);
}

// How many bytes follow the header if it is one; else none.
std::optional<std::uintmax_t> numberBytes(const Header& header)
{
    if (header.magic != magic || header.levelCount < 1 || header.levelCount > mostLevels)
        return std::nullopt;
    std::uintmax_t bytes = 0;
    for (const auto& shape : std::span(header.shapes).first(header.levelCount)) {
        if (!isSane(shape))
            return std::nullopt;
        const std::uintmax_t texelBytes =
            shape.format == static_cast<int>(PixelFormat::float32) ? 4 * sizeof(float) : 4;
        bytes +=
            texelBytes * static_cast<std::uintmax_t>(shape.width) * static_cast<std::uintmax_t>(shape.height);
    }
    return bytes;
}

Picture blankLevel(const Shape& shape)
{
    Picture level{shape.width, shape.height, static_cast<PixelFormat>(shape.format), {}, {}};
    const auto numbers = 4 * static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height);
    if (level.format == PixelFormat::float32)
        level.floats.resize(numbers);
    else
        level.bytes.resize(numbers);
    return level;
}

bool readInto(std::istream& in, std::span<std::byte> bytes)
{
    return static_cast<bool>(
        in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())));
}

void write(std::ostream& out, std::span<const std::byte> bytes)
{
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

} // namespace

void writeEntry(const std::filesystem::path& path, const std::string& key, const std::vector<Picture>& levels)
{
    PendingFile pending(path);
    std::ofstream out(pending.path(), std::ios::binary | std::ios::trunc);
    const Header header = headerOf(key, levels);
    write(out, std::as_bytes(std::span(&header, 1)));
    for (const auto& level : levels)
        write(out, numbersOf(level));
    out.close();
    if (!out)
        fail(ExitCode::cannotWrite, {path.string()}, "the file could not be written to its end",
             "make room on the disk");
    pending.commit();
}

// The file's size is checked against its header before memory is taken for what the header claims.
std::optional<std::vector<Picture>> readEntry(const std::filesystem::path& path, const std::string& key)
{
    std::error_code fault;
    const auto size = std::filesystem::file_size(path, fault);
    std::ifstream in(path, std::ios::binary);
    Header header{};
    if (fault || !readInto(in, std::as_writable_bytes(std::span(&header, 1))))
        return std::nullopt;
    const auto following = numberBytes(header);
    if (!following || sizeof(Header) + *following != size)
        return std::nullopt;
    std::vector<Picture> levels;
    for (const auto& shape : std::span(header.shapes).first(header.levelCount)) {
        levels.push_back(blankLevel(shape));
        if (!readInto(in, numbersOf(levels.back())))
            return std::nullopt;
    }
    if (checksumOf(key, header, levels) != header.checksum)
        return std::nullopt;
    return levels;
}

std::uintmax_t entryBytes(const std::vector<Picture>& levels)
{
    std::uintmax_t bytes = sizeof(Header);
    for (const auto& level : levels)
        bytes += numbersOf(level).size();
    return bytes;
}

} // namespace dioptre
