#include "base/exr_header.h"

#include "base/picture_codecs.h"

#include <algorithm>
#include <cstdint>

namespace dioptre
{
namespace
{

// https://openexr.com/en/latest/OpenEXRFileLayout.html: attributes, each a name, a type, a size and that many
// bytes, numbers in little-endian order; an empty name ends a header.
class ExrHeaders
{
public:
    ExrHeaders(const std::filesystem::path& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

    void check()
    {
        constexpr std::size_t versionAt = 4;
        at_ = versionAt;
        constexpr std::int64_t manyParts = 0x1000;
        const bool several = (nextInt() & manyParts) != 0;
        while (checkNext() && several) { // an empty header ends those of several parts
        }
    }

private:
    // Whether there was an attribute in it.
    bool checkNext()
    {
        std::int64_t width = 0, height = 0, tileWidth = 0, tileHeight = 0;
        bool any = false;
        for (std::string name = nextName(); !name.empty(); name = nextName()) {
            any = true;
            const std::string type = nextName();
            const std::int64_t size = nextInt();
            const std::size_t value = at_;
            if (size < 0 || static_cast<std::size_t>(size) > bytes_.size() - at_)
                failBroken(path_, "its attribute " + name + " is longer than the file");
            if (type == "box2i" && size == 16 && (name == "dataWindow" || name == "displayWindow")) {
                const std::int64_t left = nextInt(), top = nextInt();
                const std::int64_t columns = nextInt() - left + 1, rows = nextInt() - top + 1;
                checkSize(path_, columns, rows);
                if (name == "dataWindow") {
                    width = columns;
                    height = rows;
                }
            } else if (type == "tiledesc" && size == 9) {
                tileWidth = std::max<std::int64_t>(nextInt(), 1);
                tileHeight = std::max<std::int64_t>(nextInt(), 1);
            } else if (name == "chunkCount" && size == 4) {
                checkChunks(nextInt());
            }
            at_ = value + static_cast<std::size_t>(size);
        }
        if (tileWidth > 0)
            checkChunks(((width + tileWidth - 1) / tileWidth) * ((height + tileHeight - 1) / tileHeight));
        return any;
    }

    // The file lists a place of 8 bytes for each.
    void checkChunks(std::int64_t count) const
    {
        if (count < 0 || static_cast<std::uint64_t>(count) > bytes_.size() / 8)
            failBroken(path_, "it claims more chunks than it could list");
    }

    std::string nextName()
    {
        const auto end = bytes_.find('\0', at_);
        if (end == std::string::npos)
            failBroken(path_, "its header does not end");
        std::string name = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return name;
    }

    std::int64_t nextInt()
    {
        if (bytes_.size() - at_ < 4)
            failBroken(path_, "its header does not end");
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < 4; ++i)
            number |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(bytes_[at_ + i])) << (8 * i);
        at_ += 4;
        return static_cast<std::int32_t>(number);
    }

    const std::filesystem::path& path_;
    const std::string& bytes_;
    std::size_t at_ = 0;
};

} // namespace

void checkExrHeaders(const std::filesystem::path& path, const std::string& bytes)
{
    ExrHeaders(path, bytes).check();
}

} // namespace dioptre
