#include "scene/scene_pictures.h"

#include "scene/sections.h"

namespace dioptre
{
namespace
{

// The strings in a value, a list's too.
void collectNames(const Value& value, std::vector<std::string>& names)
{
    if (const auto* name = std::get_if<std::string>(&value.data))
        names.push_back(*name);
    if (const auto* list = std::get_if<Array>(&value.data))
        for (const Value& element : *list)
            collectNames(element, names);
}

// Under every key "image", wherever it stands: a scene that is half changed has faults.
void collectImages(const Value& value, std::vector<std::string>& names)
{
    if (const auto* list = std::get_if<Array>(&value.data))
        for (const Value& element : *list)
            collectImages(element, names);
    if (const auto* table = std::get_if<Table>(&value.data))
        for (const Entry& entry : table->entries) {
            if (entry.key == "image")
                collectNames(entry.value, names);
            collectImages(entry.value, names);
        }
}

} // namespace

std::vector<std::filesystem::path>
picturesNamedIn(const std::string& text, const std::filesystem::path& scene, const SearchPlaces& places)
{
    std::vector<std::string> names;
    try {
        collectImages(parseDocument(text, scene.string()), names);
    } catch (const Error&) {
        return {};
    }
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names)
        for (const auto& candidate : candidatesOf(name, pictureSearch(scene, places)))
            files.push_back(candidate);
    return files;
}

} // namespace dioptre
