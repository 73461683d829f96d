#include "command/input.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cstdlib>

namespace dioptre
{

std::filesystem::path glslFolder()
{
    if (const char* chosen = std::getenv("DIOPTRE_GLSL"); chosen != nullptr && *chosen != '\0')
        return chosen;
    auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    while (true) {
        if (std::filesystem::is_regular_file(folder / "glsl" / "ray_trace.frag"))
            return folder / "glsl";
        if (folder == folder.root_path())
            fail(ExitCode::inputMissing, "no folder above the program holds glsl/ray_trace.frag",
                 "set DIOPTRE_GLSL to the folder glsl/ of dioptre's sources");
        folder = folder.parent_path();
    }
}

std::vector<std::string> galleryNames()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(glslFolder() / "scenes"))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Input findInput(const std::string& text)
{
    const std::filesystem::path path(text);
    const auto extension = path.extension();
    if (extension == ".toml" || extension == ".frag" || extension == ".glsl") {
        if (!std::filesystem::is_regular_file(path))
            fail(ExitCode::inputMissing, text + " is no file that can be read", "check the path");
        return {path, path.stem().string(), extension != ".toml"};
    }
    const auto names = galleryNames();
    if (std::find(names.begin(), names.end(), text) != names.end())
        return {glslFolder() / "scenes" / (text + ".toml"), text, false};
    const auto nearest = nearestWord(text, names);
    fail(ExitCode::inputMissing,
         "'" + text + "' is neither a scene of the gallery nor a .toml, .frag or .glsl file",
         nearest.empty() ? "the gallery holds " + join(names, ", ") : "did you mean '" + nearest + "'?");
}

} // namespace dioptre
