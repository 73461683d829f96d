#include "base/path_trail.h"

#include <deque>
#include <system_error>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

constexpr int mostTrailLinks = 40; // as the kernel's own limit, MAXSYMLINKS

// Puts the names of `path` before those that are still to be walked.
void putFirst(std::deque<std::string>& names, const fs::path& path)
{
    auto at = names.begin();
    for (const fs::path& part : path.relative_path())
        if (!part.empty() && part != ".")
            at = names.insert(at, part.string()) + 1;
}

} // namespace

bool PathTrail::leadsLike(const PathTrail& other) const
{
    return folders == other.folders && links == other.links && end == other.end && whole == other.whole;
}

PathTrail trailOf(const fs::path& path)
{
    PathTrail trail;
    std::deque<std::string> names;
    putFirst(names, path);
    fs::path folder = "/";
    trail.folders.push_back(folder);
    while (!names.empty()) {
        const std::string name = names.front();
        names.pop_front();
        if (name == "..") {
            folder = folder.parent_path(); // the root is its own parent
            continue;
        }
        const fs::path at = folder / name;
        trail.end = {folder, name};
        std::error_code fault;
        const fs::file_status status = fs::symlink_status(at, fault);
        if (fs::is_symlink(status) && trail.links.size() < mostTrailLinks) {
            trail.links.push_back(trail.end);
            const fs::path target = fs::read_symlink(at, fault);
            if (target.is_absolute())
                folder = "/";
            putFirst(names, target);
        } else if (names.empty()) {
            trail.whole = true;
            trail.exists = fs::exists(status) && !fs::is_symlink(status);
        } else if (fs::is_directory(status)) {
            folder = at;
            trail.folders.push_back(folder);
        } else {
            return trail;
        }
    }
    return trail;
}

} // namespace dioptre
