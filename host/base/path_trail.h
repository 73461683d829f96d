// The folders, links and the last name by which a path leads to its file: what to watch to learn of changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

// A name in a folder. The folder is named without symbolic links.
struct FolderEntry {
    std::filesystem::path folder;
    std::string name;

    bool operator==(const FolderEntry&) const = default;
};

struct PathTrail {
    std::vector<std::filesystem::path> folders; // that exist and are passed, from the root; no symbolic links
    std::vector<FolderEntry> links;             // symbolic links that are followed
    FolderEntry end;     // the file's own entry, or the first one that is missing or no folder
    bool whole = false;  // `end` is the file's own entry, whether or not it is there
    bool exists = false; // the file is there

    // Whether both lead to the same place; not whether something is there.
    bool leadsLike(const PathTrail& other) const;
};

// Of an absolute path, as the kernel would walk it now. Never throws: what cannot be looked at is missing.
PathTrail trailOf(const std::filesystem::path& path);

} // namespace dioptre
