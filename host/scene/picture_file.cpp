#include "scene/sections.h"

#include "base/text.h"
#include "scene/value_reader.h"

#include <fmt/format.h>

namespace dioptre
{

namespace
{

namespace fs = std::filesystem;

// Of Debian's package xplanet-images, whose earth the gallery shows where it is installed.
constexpr const char* planetPictures = "/usr/share/xplanet/images";

// The strings, in order.
std::vector<const Value*> namesIn(const Value& value, std::string_view key)
{
    constexpr std::string_view wanted =
        "a file name, or a list of names of which the first that exists is taken";
    std::vector<const Value*> names;
    if (const auto* list = std::get_if<Array>(&value.data))
        for (const Value& element : *list)
            names.push_back(&element);
    else
        names.push_back(&value);
    if (names.empty())
        refuse(value, key, wanted);
    for (const Value* name : names)
        if (textFrom(*name, key, wanted).empty())
            fail(ExitCode::badInput, value.where, fmt::format("{} has an empty name", key), "name a file");
    return names;
}

// Values of --set stand in no line of a file.
bool isTheUsersOwn(const Value& name)
{
    return name.where.line == 0;
}

} // namespace

Search pictureSearch(const fs::path& scene, const SearchPlaces& places)
{
    std::vector<fs::path> data;
    if (!places.glslFolder.empty())
        data = {texturesFolder(places), planetPictures};
    return searchFrom(scene, places, data, "scene");
}

std::string pictureFile(const Value& value, std::string_view key, const Search& search)
{
    std::vector<std::string> tried;
    for (const Value* name : namesIn(value, key)) {
        const auto& text = std::get<std::string>(name->data);
        const fs::path found =
            isTheUsersOwn(*name) ? lookAnywhere(text, search) : lookFor(text, search, name->where);
        if (!found.empty())
            return found.string();
        for (const fs::path& candidate : candidatesOf(text, search))
            tried.push_back(candidate.string());
    }
    fail(ExitCode::inputMissing, value.where, fmt::format("{}: no such file: {}", key, join(tried, ", ")),
         "put the picture there, or name one that exists");
}

} // namespace dioptre
