#include "scene/document_path.h"

#include "base/text.h"
#include "scene/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace dioptre
{

namespace
{

std::vector<std::string> keysOf(const Table& table)
{
    std::vector<std::string> keys;
    for (const Entry& entry : table.entries)
        keys.push_back(entry.key);
    return keys;
}

[[noreturn]] void leadsNowhere(const DocumentPath& path, const std::string& what, const std::string& word,
                               const std::vector<std::string>& known)
{
    const std::string nearest = nearestWord(word, known);
    if (!nearest.empty())
        fail(path.fault, path.where, what, fmt::format("did you mean '{}'?", nearest));
    fail(path.fault, path.where, what,
         known.empty() ? "there is nothing to set in it" : "it has " + join(known, ", "));
}

Value& elementOf(Array& array, const std::string& step, const DocumentPath& path)
{
    std::size_t index = 0;
    const char* end = step.data() + step.size();
    const auto [stop, error] = std::from_chars(step.data(), end, index);
    if (error != std::errc{} || stop != end || index >= array.size())
        fail(path.fault, path.where, fmt::format("'{}' is no element of an array of {}", step, array.size()),
             array.empty() ? "the array is empty" : fmt::format("count from 0 to {}", array.size() - 1));
    return array[index];
}

// Looks into the document.
struct NamedObject {
    std::string_view name;
    std::string_view kind;
    std::size_t index = 0; // among its kind
};

// Every object that has a name.
std::vector<NamedObject> namedObjects(const Table& document)
{
    std::vector<NamedObject> named;
    for (const std::string& kind : objectKinds()) {
        const Value* objects = find(document, kind);
        const auto* array = objects ? std::get_if<Array>(&objects->data) : nullptr;
        if (!array)
            continue;
        for (std::size_t i = 0; i < array->size(); ++i)
            if (const auto* table = std::get_if<Table>(&(*array)[i].data))
                if (const Value* name = find(*table, "name");
                    name && std::holds_alternative<std::string>(name->data))
                    named.push_back({std::get<std::string>(name->data), kind, i});
    }
    return named;
}

// A section whose keys all have defaults may be absent from the file.
void createSection(Table& document, const std::string& key, const SourcePosition& where)
{
    const bool optional = key == "camera" || key == "sky" || key == "trace" || key == "plan" ||
                          key == "raster" || key == "output";
    if (optional && !find(document, key))
        document.entries.push_back({key, where, {Table{}, where}});
}

Steps split(const std::string& path)
{
    Steps steps;
    std::size_t start = 0;
    for (std::size_t dot = 0; dot != std::string::npos; start = dot + 1) {
        dot = path.find('.', start);
        steps.push_back(path.substr(start, dot - start));
    }
    return steps;
}

// The steps of a path, those to the object in place of its name, which may itself hold dots.
Steps withoutName(Table& document, const DocumentPath& path)
{
    const Steps written = split(path.text);
    if (std::ranges::find(sceneKeys(), written.front()) != sceneKeys().end()) {
        createSection(document, written.front(), path.where);
        return written;
    }
    const std::vector<NamedObject> named = namedObjects(document);
    NamedObject nearest;
    for (const NamedObject& object : named) {
        const std::size_t length = object.name.size();
        if (length > nearest.name.size() && path.text.starts_with(object.name) && path.text[length] == '.')
            nearest = object;
    }
    if (nearest.name.empty()) {
        std::vector<std::string> known = sceneKeys();
        for (const NamedObject& object : named)
            known.emplace_back(object.name);
        leadsNowhere(path, fmt::format("the scene has no '{}'", written.front()), written.front(), known);
    }
    Steps steps{std::string(nearest.kind), std::to_string(nearest.index)};
    for (const std::string& step : split(path.text.substr(nearest.name.size() + 1)))
        steps.push_back(step);
    return steps;
}

Value& stepInto(Value& value, const std::string& step, const DocumentPath& path)
{
    if (auto* array = std::get_if<Array>(&value.data))
        return elementOf(*array, step, path);
    auto* table = std::get_if<Table>(&value.data);
    if (!table)
        fail(path.fault, path.where, fmt::format("'{}' leads into {}", step, inWords(value)),
             "end the path before it");
    Value* next = find(*table, step);
    if (!next)
        leadsNowhere(path, fmt::format("there is no '{}'", step), step, keysOf(*table));
    return *next;
}

} // namespace

Steps resolve(Value& document, const DocumentPath& path)
{
    Steps steps = withoutName(std::get<Table>(document.data), path);
    Value* value = &document;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i)
        value = &stepInto(*value, steps[i], path);
    if (!std::holds_alternative<Table>(value->data))
        stepInto(*value, steps.back(), path);
    return steps;
}

void setAt(Value& document, const Steps& steps, const Value& value, const SourcePosition& where)
{
    Value* target = &document;
    for (const std::string& step : steps) {
        if (auto* array = std::get_if<Array>(&target->data)) {
            target = &array->at(std::stoul(step));
            continue;
        }
        auto& table = std::get<Table>(target->data);
        if (!find(table, step))
            table.entries.push_back({step, where, value});
        target = find(table, step);
    }
    *target = value;
}

bool overlap(const Steps& a, const Steps& b)
{
    const std::size_t common = std::min(a.size(), b.size());
    return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(common), b.begin());
}

} // namespace dioptre
