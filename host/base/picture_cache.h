// Prepared pictures, kept in a folder between runs: decoding and shrinking take longer than drawing.
#pragma once

#include "base/picture.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

class PictureCache
{
public:
    // Keeps nothing.
    PictureCache() = default;

    // Keeps up to `most_bytes` in `folder`, which is made when the first picture is kept; the pictures that
    // were not used for longest are removed.
    explicit PictureCache(std::filesystem::path folder,
                          std::uintmax_t most_bytes = std::uintmax_t{512} << 20);

    // The picture of `file` as `make` prepares it, with its levels; kept if it was not yet. `preparation`
    // names what `make` does. It counts as the same while the file's place, size, times and inode and this
    // program are. Files in the folder that are damaged or of others are passed over, and a folder that
    // cannot be written to is no error; what `make` throws is.
    std::vector<Picture> levelsOf(const std::filesystem::path& file, std::string_view preparation,
                                  const std::function<std::vector<Picture>()>& make) const;

private:
    void keep(const std::string& key, const std::vector<Picture>& levels) const;
    void removeOldest() const;
    std::filesystem::path entryOf(const std::string& key) const;

    std::filesystem::path folder_;
    std::uintmax_t most_bytes_ = 0;
};

} // namespace dioptre
