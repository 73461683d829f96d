#include "command/input.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cstdlib>

namespace dioptre
{
namespace
{

// "" where it is not set.
std::string environment(const char* name)
{
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

} // namespace

std::filesystem::path glslFolder()
{
    if (const auto chosen = environment("DIOPTRE_GLSL"); !chosen.empty()) {
        if (!std::filesystem::is_regular_file(std::filesystem::path(chosen) / "ray_trace.frag"))
            fail(ExitCode::inputMissing, "DIOPTRE_GLSL=" + chosen + " holds no ray_trace.frag",
                 "set it to the folder glsl/ of dioptre's sources, or not at all");
        return (std::filesystem::path(chosen) / "").parent_path(); // with or without a slash at its end
    }
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

SearchPlaces searchPlaces(const std::vector<std::string>& included)
{
    return {{included.begin(), included.end()}, glslFolder()};
}

// https://specifications.freedesktop.org/basedir-spec: a relative folder is not to be used.
PictureCache pictureCache()
{
    const auto chosen = environment("DIOPTRE_CACHE");
    if (chosen == "off")
        return {};
    if (!chosen.empty())
        return PictureCache(chosen);
    if (const std::filesystem::path xdg = environment("XDG_CACHE_HOME"); xdg.is_absolute())
        return PictureCache(xdg / "dioptre");
    if (const std::filesystem::path home = environment("HOME"); home.is_absolute())
        return PictureCache(home / ".cache" / "dioptre");
    return {};
}

namespace
{

std::vector<std::string> galleryWith(const std::string& extension)
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(glslFolder() / "scenes"))
        if (entry.path().extension() == extension)
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

std::vector<std::string> galleryNames()
{
    return galleryWith(".toml");
}

std::vector<std::string> galleryShaders()
{
    return galleryWith(".frag");
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
    auto names = galleryNames();
    if (std::ranges::find(names, text) != names.end())
        return {glslFolder() / "scenes" / (text + ".toml"), text, false};
    const auto shaders = galleryShaders();
    if (std::ranges::find(shaders, text) != shaders.end())
        return {glslFolder() / "scenes" / (text + ".frag"), text, true};
    names.insert(names.end(), shaders.begin(), shaders.end());
    const auto nearest = nearestWord(text, names);
    fail(ExitCode::inputMissing,
         "'" + text + "' is neither a scene of the gallery nor a .toml, .frag or .glsl file",
         nearest.empty() ? "the gallery holds " + join(names, ", ") : "did you mean '" + nearest + "'?");
}

} // namespace dioptre
