#include "base/picture_cache.h"

#include "base/error.h"
#include "base/picture_entry.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <sys/stat.h>
#include <utility>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* extension = ".levels";

long long nanoseconds(const timespec& time)
{
    return 1'000'000'000LL * time.tv_sec + time.tv_nsec;
}

// What tells a file from an earlier one of the same name; "" where there is none.
std::string identityOf(const fs::path& file)
{
    struct stat status {
    };
    if (::stat(file.c_str(), &status) != 0)
        return "";
    return fmt::format("{} {} {} {} {}", status.st_dev, status.st_ino, status.st_size,
                       nanoseconds(status.st_mtim), nanoseconds(status.st_ctim));
}

// A build of dioptre reads what it kept itself: another may prepare pictures otherwise.
const std::string& programIdentity()
{
    static const std::string identity = identityOf("/proc/self/exe");
    return identity;
}

// Clocks of file systems tick as slowly as every two seconds: a file this young may change once more without
// its times telling.
bool isYoung(const fs::path& file)
{
    std::error_code fault;
    const auto written = fs::last_write_time(file, fault);
    return fault || fs::file_time_type::clock::now() - written < std::chrono::seconds(2);
}

} // namespace

PictureCache::PictureCache(fs::path folder, std::uintmax_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes)
{
}

std::vector<Picture> PictureCache::levelsOf(const fs::path& file, std::string_view preparation,
                                            const std::function<std::vector<Picture>()>& make) const
{
    const std::string identity = identityOf(file);
    if (folder_.empty() || identity.empty())
        return make();
    std::error_code ignored;
    const std::string key = fmt::format("{}\n{}\n{}\n{}\n", fs::absolute(file, ignored).string(), identity,
                                        preparation, programIdentity());
    if (auto kept = readEntry(entryOf(key), key)) {
        fs::last_write_time(entryOf(key), fs::file_time_type::clock::now(), ignored); // of its last use
        return *std::move(kept);
    }
    std::vector<Picture> levels = make();
    if (!isYoung(file) && entryBytes(levels) <= most_bytes_)
        keep(key, levels);
    return levels;
}

void PictureCache::keep(const std::string& key, const std::vector<Picture>& levels) const
{
    std::error_code fault;
    fs::create_directories(folder_, fault);
    try {
        writeEntry(entryOf(key), key, levels);
    } catch (const Error&) {
        return; // the next run decodes again
    }
    removeOldest();
}

// Other processes may remove and add at the same time: what is gone is passed over.
void PictureCache::removeOldest() const
{
    struct Entry {
        fs::file_time_type used;
        std::uintmax_t bytes;
        fs::path path;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    std::error_code fault;
    for (fs::directory_iterator at(folder_, fault), end; !fault && at != end; at.increment(fault)) {
        std::error_code gone;
        const Entry entry{at->last_write_time(gone), at->file_size(gone), at->path()};
        if (gone || entry.path.extension() != extension)
            continue;
        entries.push_back(entry);
        total += entry.bytes;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
    for (auto entry = entries.begin(); entry != entries.end() && total > most_bytes_; ++entry) {
        fs::remove(entry->path, fault);
        total -= entry->bytes;
    }
}

fs::path PictureCache::entryOf(const std::string& key) const
{
    return folder_ / fmt::format("{:016x}{}", fingerprint(key), extension);
}

} // namespace dioptre
