#include "command/bench_input.h"

#include "base/error.h"
#include "command/input.h"
#include "command/plain_options.h"
#include "render/plain.h"
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
    const auto shaders = galleryShaders();
    return std::ranges::count(names, text) + std::ranges::count(shaders, text) > 0 ||
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

// Takes "method=NAME" out of the overrides; the last one counts.
std::string takeMethod(std::vector<std::string>& overrides, const std::string& method)
{
    const std::string key = "method=";
    std::string found = method;
    for (const auto& change : overrides)
        if (change.starts_with(key))
            found = change.substr(key.size());
    std::erase_if(overrides, [&](const std::string& change) { return change.starts_with(key); });
    return found;
}

} // namespace

BenchInput readBenchInput(const std::string& text, const SearchPlaces& places, const std::string& method)
{
    const std::size_t parting = partingAt(text);
    const Input input = findInput(text.substr(0, parting));
    BenchInput read{text, input.path, {}, input.plainShader, {}, places};
    if (parting + 1 == text.size())
        fail(ExitCode::usage, text + " has nothing behind its @",
             "write path=value there, as in still_life@trace.form=loop, or leave the @ out");
    if (parting < text.size())
        read.overrides = splitOverrides(text.substr(parting + 1));
    if (!read.plainShader)
        read.method = methodNamed(takeMethod(read.overrides, method));
    else if (method != "trace")
        fail(ExitCode::usage, text + " is a plain shader, and --method is for scenes",
             "write the method behind the scenes that it is for, as in still_life@method=phong:64");
    return read;
}

Scene sceneOf(const BenchInput& input)
{
    try {
        return loadScene(input.file, input.overrides, 0.0, input.places);
    } catch (const Error& error) { // "--set …" alone would not say which of the inputs it is
        failAgain(error, input.overrides.empty() ? error.what() : input.name + ": " + error.what());
    }
}

MethodDrawing drawingOf(const BenchInput& input, const ViewSettings& view, const ContextInfo& context)
{
    if (!input.plainShader)
        return methodDrawing(sceneOf(input), view, input.method, context);
    MethodDrawing made;
    PlainSettings plain;
    plain.values = plainValues(input.overrides);
    plain.included = input.places.included;
    made.drawing = std::make_unique<PlainRenderer>(input.file, view, plain, context);
    return made;
}

} // namespace dioptre
