#include "scene/sections.h"

#include "base/text.h"
#include "scene/value_reader.h"

#include <fmt/format.h>

namespace dioptre
{

namespace
{

namespace fs = std::filesystem;

std::vector<std::string> candidates(const Value& value, std::string_view key)
{
    constexpr std::string_view wanted =
        "a file name, or a list of names of which the first that exists is taken";
    std::vector<std::string> names;
    if (std::holds_alternative<Array>(value.data))
        for (const Value& element : std::get<Array>(value.data))
            names.push_back(textFrom(element, key, wanted));
    else
        names.push_back(textFrom(value, key, wanted));
    if (names.empty())
        refuse(value, key, wanted);
    for (const std::string& name : names)
        if (name.empty())
            fail(ExitCode::badInput, value.where, fmt::format("{} has an empty name", key), "name a file");
    return names;
}

// Where a name may lie. The gallery's scenes are in glsl/scenes/ and its pictures in textures/.
std::vector<fs::path> placesOf(const std::string& name, const fs::path& folder)
{
    std::vector<fs::path> places{(folder / name).lexically_normal()};
    if (name.find('/') == std::string::npos)
        places.push_back((folder / ".." / ".." / "textures" / name).lexically_normal());
    return places;
}

} // namespace

std::string pictureFile(const Value& value, std::string_view key, const fs::path& folder)
{
    std::vector<std::string> tried;
    for (const std::string& name : candidates(value, key))
        for (const fs::path& place : placesOf(name, folder)) {
            std::error_code ignored;
            if (fs::is_regular_file(place, ignored))
                return place.string();
            tried.push_back(place.string());
        }
    fail(ExitCode::inputMissing, value.where, fmt::format("{}: no such file: {}", key, join(tried, ", ")),
         "put the picture there, or name one that exists");
}

} // namespace dioptre
