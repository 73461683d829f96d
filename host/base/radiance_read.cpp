#include "base/picture_codecs.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace dioptre
{
namespace
{

// Reads Radiance pictures (Ward, "Real Pixels", Graphics Gems II). Not stb: its reader hangs on a file cut
// short.
class RadianceReader
{
public:
    RadianceReader(const std::filesystem::path& path, const std::string& bytes) : path_(path), bytes_(bytes)
    {
    }

    // The text lines up to the empty one, then "-Y height +X width".
    Picture blank()
    {
        std::string line = nextLine();
        for (line = nextLine(); !line.empty(); line = nextLine())
            if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
                failBroken(path_, line + " is not 32-bit_rle_rgbe");
        const std::string size = nextLine();
        long long width = 0, height = 0;
        if (std::sscanf(size.c_str(), "-Y %lld +X %lld", &height, &width) != 2)
            failBroken(path_, "its size line must read -Y height +X width");
        checkSize(path_, width, height);
        // A row takes a texel, and a run of it where there are more.
        checkHolds(path_, bytes_.size() - at_, static_cast<std::uintmax_t>(height) * (width > 1 ? 8 : 4));
        return blankPicture(path_, width, height, PixelFormat::float32);
    }

    // One row of red, green, blue and exponent bytes, each of the four in a run of its own.
    void nextRow(std::array<std::vector<std::uint8_t>, 4>& planes, std::size_t width)
    {
        for (auto& plane : planes)
            plane.clear();
        const bool isPacked = width >= 8 && width < 32768 && at_ + 4 <= bytes_.size() && byteAt(at_) == 2 &&
                              byteAt(at_ + 1) == 2 && byteAt(at_ + 2) < 128;
        if (!isPacked)
            return readFlat(planes, width);
        if (byteAt(at_ + 2) * 256u + byteAt(at_ + 3) != width)
            failBroken(path_, "a row has another length than the picture");
        at_ += 4;
        for (auto& plane : planes)
            readPacked(plane, width);
    }

private:
    std::uint8_t byteAt(std::size_t at) const
    {
        return static_cast<std::uint8_t>(bytes_[at]);
    }

    std::uint8_t nextByte()
    {
        if (at_ >= bytes_.size())
            failBroken(path_, "its pixels end too early");
        return byteAt(at_++);
    }

    std::string nextLine()
    {
        const std::size_t end = bytes_.find('\n', at_);
        if (end == std::string::npos)
            failBroken(path_, "its header does not end");
        std::string line = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return line;
    }

    // Four bytes a texel, where (1, 1, 1, n) repeats the last texel; successive repeats are higher digits of
    // the count.
    void readFlat(std::array<std::vector<std::uint8_t>, 4>& planes, std::size_t width)
    {
        int shift = 0;
        while (planes[0].size() < width) {
            const std::uint8_t red = nextByte(), green = nextByte(), blue = nextByte(), exponent = nextByte();
            if (red != 1 || green != 1 || blue != 1) {
                planes[0].push_back(red);
                planes[1].push_back(green);
                planes[2].push_back(blue);
                planes[3].push_back(exponent);
                shift = 0;
                continue;
            }
            const std::size_t count = shift < 24 ? std::size_t{exponent} << shift : 0;
            if (count == 0 || planes[0].empty() || planes[0].size() + count > width)
                failBroken(path_, "a run is longer than its row");
            for (auto& plane : planes)
                plane.insert(plane.end(), count, std::uint8_t{plane.back()});
            shift += 8;
        }
    }

    // Runs: n > 128 repeats the next byte n - 128 times, n <= 128 is followed by n bytes.
    void readPacked(std::vector<std::uint8_t>& plane, std::size_t width)
    {
        while (plane.size() < width) {
            const std::size_t code = nextByte();
            const std::size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || plane.size() + count > width)
                failBroken(path_, "a run is longer than its row");
            if (code > 128)
                plane.insert(plane.end(), count, nextByte());
            else
                for (std::size_t i = 0; i < count; ++i)
                    plane.push_back(nextByte());
        }
    }

    const std::filesystem::path& path_;
    const std::string& bytes_;
    std::size_t at_ = 0;
};

} // namespace

// Mantissa m and exponent e stand for m · 2^(e - 136), without the half step that Radiance's own tools add;
// stb and OpenCV read them so too. e = 0 is black.
Picture decodeRadiance(const std::filesystem::path& path, const std::string& bytes)
{
    RadianceReader reader(path, bytes);
    Picture picture = reader.blank();
    const auto width = static_cast<std::size_t>(picture.width);
    std::array<std::vector<std::uint8_t>, 4> planes;
    for (std::size_t first = 0; first < picture.floats.size(); first += rowLength(picture)) {
        reader.nextRow(planes, width);
        for (std::size_t x = 0; x < width; ++x) {
            const int exponent = planes[3][x];
            const float scale = exponent == 0 ? 0.0f : std::ldexp(1.0f, exponent - 136);
            for (std::size_t channel = 0; channel < 3; ++channel)
                picture.floats[first + 4 * x + channel] = static_cast<float>(planes[channel][x]) * scale;
            picture.floats[first + 4 * x + 3] = 1.0f;
        }
    }
    flipRows(picture);
    return picture;
}

} // namespace dioptre
