#include "command/bench_input.h"

#include "base/error.h"
#include "command/input.h"
#include "scene/load.h"
#include "scene/override.h"

#include <algorithm>

namespace dioptre
{
namespace
{

bool hasExtension(const std::string& text)
{
    return text.ends_with(".toml") || text.ends_with(".frag") || text.ends_with(".glsl");
}

bool isThere(const std::string& text)
{
    const auto names = galleryNames();
    return std::find(names.begin(), names.end(), text) != names.end() ||
           (hasExtension(text) && std::filesystem::is_regular_file(text));
}

// Where the overrides' '@' stands, or the end. Folders, files and values may hold one too: that which parts
// has an input before it, or, where no input is there, what looks most like one.
std::size_t partingAt(const std::string& text)
{
    if (isThere(text))
        return text.size();
    std::size_t likely = text.size();
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + 1)) {
        const std::string before = text.substr(0, at);
        if (isThere(before))
            return at;
        const bool overrides = text.find('=', at) != std::string::npos;
        if (overrides &&
            (likely == text.size() || (hasExtension(before) && !hasExtension(text.substr(0, likely)))))
            likely = at;
    }
    return likely;
}

} // namespace

BenchInput readBenchInput(const std::string& text)
{
    const std::size_t parting = partingAt(text);
    const Input input = findInput(text.substr(0, parting));
    if (input.plainShader)
        fail(ExitCode::usage, text + " is a plain shader, and bench times scenes",
             "give a name of the gallery or a .toml file");
    if (parting == text.size())
        return {text, input.path, {}};
    if (parting + 1 == text.size())
        fail(ExitCode::usage, text + " has nothing behind its @",
             "write path=value there, as in still_life@trace.form=loop, or leave the @ out");
    return {text, input.path, splitOverrides(text.substr(parting + 1))};
}

Scene sceneOf(const BenchInput& input)
{
    try {
        return loadScene(input.scene, input.overrides);
    } catch (const Error& error) { // "--set …" alone would not say which of the inputs it is
        throw Error(error.code(), input.overrides.empty() ? error.what() : input.name + ": " + error.what());
    }
}

} // namespace dioptre
