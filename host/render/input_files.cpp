#include "render/input_files.h"

#include "render/assemble.h"
#include "render/directive.h"
#include "render/plain_text.h"
#include "scene/scene_pictures.h"

#include <algorithm>
#include <set>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

// Follows #include from file to file.
class IncludeWalk
{
public:
    explicit IncludeWalk(Search search) : search_(std::move(search)) {}

    void addFile(const fs::path& file)
    {
        if (seen_.insert(file).second)
            files_.push_back(file);
    }

    void addFileAndIncludes(const fs::path& file)
    {
        addFile(file);
        for (const auto& line : linesIn(file))
            if (const auto directive = directiveOf(line.text); directive && directive->name == "include")
                if (const auto name = includedName(*directive); name && !name->starts_with(generatedFolder))
                    addInclude(*name);
    }

    void addInclude(const std::string& name)
    {
        if (!names_.insert(name).second)
            return;
        for (const auto& candidate : candidatesOf(name, search_))
            addFile(candidate);
        if (const auto found = foundAs(name); !found.empty())
            addFileAndIncludes(found);
    }

    std::vector<fs::path> files() &&
    {
        return std::move(files_);
    }

private:
    static SourceText linesIn(const fs::path& file)
    {
        try {
            return readSource(file);
        } catch (const Error&) { // missing, or no text
            return {};
        }
    }

    fs::path foundAs(const std::string& name) const
    {
        try {
            return lookFor(name, search_, {});
        } catch (const Error&) { // it leads out of the folders
            return {};
        }
    }

    Search search_;
    std::vector<fs::path> files_;
    std::set<fs::path> seen_;
    std::set<std::string> names_;
};

} // namespace

std::vector<fs::path> filesOfScene(const fs::path& scene, const std::string& text, const SearchPlaces& places)
{
    IncludeWalk walk({{places.glslFolder}, {}, "scene"});
    walk.addFile(scene);
    for (const auto& picture : picturesNamedIn(text, scene, places))
        walk.addFile(picture);
    walk.addFileAndIncludes(places.glslFolder / "ray_trace.frag");
    for (const auto& name : includesOfGenerated())
        walk.addInclude(name);
    return std::move(walk).files();
}

std::vector<fs::path> filesOfSources(const std::vector<std::string>& names, const SearchPlaces& places)
{
    IncludeWalk walk({{places.glslFolder}, {}, "scene"});
    for (const auto& name : names)
        walk.addInclude(name);
    return std::move(walk).files();
}

std::vector<fs::path> filesOfShader(const fs::path& shader, const SearchPlaces& places)
{
    IncludeWalk walk(includeSearch(shader, places));
    walk.addFileAndIncludes(shader);
    return std::move(walk).files();
}

} // namespace dioptre
