#include "base/search_places.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

// With "..", links and a slash at the end resolved as far as the path exists.
fs::path resolved(const fs::path& path)
{
    std::error_code fault;
    const fs::path whole = fs::absolute(path.empty() ? "." : path, fault);
    fs::path real = fs::weakly_canonical(whole, fault);
    if (fault) // a circle of links, or a folder that may not be entered
        real = whole.lexically_normal();
    return real.has_filename() ? real : real.parent_path();
}

bool isFile(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

bool mayReach(const fs::path& file, const Search& search)
{
    const fs::path real = resolved(file);
    const auto holds = [&real](const fs::path& folder) {
        const fs::path root = resolved(folder);
        return std::ranges::mismatch(root, real).in1 == root.end();
    };
    return std::ranges::any_of(search.folders, holds) || std::ranges::any_of(search.mayAlsoReach, holds);
}

} // namespace

fs::path texturesFolder(const SearchPlaces& places)
{
    return (places.glslFolder / ".." / "textures").lexically_normal();
}

Search searchFrom(const fs::path& file, const SearchPlaces& places, const std::vector<fs::path>& data,
                  std::string_view owner)
{
    Search search{{file.has_parent_path() ? file.parent_path() : "."}, {}, owner};
    if (!places.glslFolder.empty())
        search.mayAlsoReach = {places.glslFolder, texturesFolder(places)};
    search.folders.insert(search.folders.end(), places.included.begin(), places.included.end());
    search.folders.insert(search.folders.end(), data.begin(), data.end());
    return search;
}

std::vector<fs::path> candidatesOf(const std::string& name, const Search& search)
{
    std::vector<fs::path> candidates;
    for (const fs::path& folder : search.folders) {
        fs::path candidate = (folder / name).lexically_normal();
        if (std::ranges::find(candidates, candidate) == candidates.end())
            candidates.push_back(std::move(candidate));
    }
    return candidates;
}

fs::path lookFor(const std::string& name, const Search& search, const SourcePosition& where)
{
    bool mayBeThere = false;
    for (const fs::path& candidate : candidatesOf(name, search)) {
        const bool allowed = mayReach(candidate, search);
        mayBeThere = mayBeThere || allowed;
        if (!isFile(candidate))
            continue;
        if (allowed)
            return candidate;
        mayBeThere = false;
        break;
    }
    if (!mayBeThere)
        fail(ExitCode::badInput, where,
             fmt::format("\"{}\" leads out of the {}'s folder and of those that it may use", name,
                         search.owner),
             fmt::format("move it beside the {}, or name its folder by --include FOLDER", search.owner));
    return {};
}

fs::path lookAnywhere(const std::string& name, const Search& search)
{
    const auto candidates = candidatesOf(name, search);
    const auto found = std::ranges::find_if(candidates, isFile);
    return found == candidates.end() ? fs::path() : *found;
}

} // namespace dioptre
