#include "scene/override.h"

#include "base/text.h"
#include "scene/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace dioptre
{

namespace
{

struct Override {
    SourcePosition place; // "--set path=value"
    std::string path;
    Value value;
};

bool hasTable(const Value& value)
{
    if (const auto* array = std::get_if<Array>(&value.data))
        return std::ranges::any_of(*array, hasTable);
    return std::holds_alternative<Table>(value.data);
}

Override parse(const std::string& text)
{
    const SourcePosition place{"--set " + text};
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        fail(ExitCode::usage, place, "an override is a path and a value", "write path=value");
    const std::string written = text.substr(equals + 1);
    Value value = parseValue(written, place).value_or(Value{written, place});
    if (hasTable(value)) // a table has an order in the file, which an override cannot give
        fail(ExitCode::usage, place, "an override cannot set a table", "set its keys one by one");
    return {place, text.substr(0, equals), std::move(value)};
}

std::vector<std::string> keysOf(const Table& table)
{
    std::vector<std::string> keys;
    for (const Entry& entry : table.entries)
        keys.push_back(entry.key);
    return keys;
}

[[noreturn]] void leadsNowhere(const Override& change, const std::string& what, const std::string& word,
                               const std::vector<std::string>& known)
{
    const std::string nearest = nearestWord(word, known);
    if (!nearest.empty())
        fail(ExitCode::usage, change.place, what, fmt::format("did you mean '{}'?", nearest));
    fail(ExitCode::usage, change.place, what,
         known.empty() ? "there is nothing to set in it" : "it has " + join(known, ", "));
}

Value& elementOf(Array& array, const std::string& step, const Override& change)
{
    std::size_t index = 0;
    const char* end = step.data() + step.size();
    const auto [stop, error] = std::from_chars(step.data(), end, index);
    if (error != std::errc{} || stop != end || index >= array.size())
        fail(ExitCode::usage, change.place,
             fmt::format("'{}' is no element of an array of {}", step, array.size()),
             array.empty() ? "the array is empty" : fmt::format("count from 0 to {}", array.size() - 1));
    return array[index];
}

// Every object's table under its name.
std::vector<std::pair<std::string, Value*>> namedObjects(Table& document)
{
    std::vector<std::pair<std::string, Value*>> named;
    for (const std::string& kind : objectKinds()) {
        Value* objects = find(document, kind);
        auto* array = objects ? std::get_if<Array>(&objects->data) : nullptr;
        if (!array)
            continue;
        for (Value& object : *array)
            if (auto* table = std::get_if<Table>(&object.data))
                if (Value* name = find(*table, "name");
                    name && std::holds_alternative<std::string>(name->data))
                    named.emplace_back(std::get<std::string>(name->data), &object);
    }
    return named;
}

// A section whose keys all have defaults may be absent from the file.
void createSection(Table& document, const std::string& key, const SourcePosition& place)
{
    const bool optional = key == "camera" || key == "sky" || key == "trace" || key == "plan";
    if (optional && !find(document, key))
        document.entries.push_back({key, place, {Table{}, place}});
}

std::vector<std::string> split(const std::string& path)
{
    std::vector<std::string> steps;
    std::size_t start = 0;
    for (std::size_t dot = 0; dot != std::string::npos; start = dot + 1) {
        dot = path.find('.', start);
        steps.push_back(path.substr(start, dot - start));
    }
    return steps;
}

// The first step: a section of the scene, or an object's name, which may itself hold dots; the rest of the
// path remains.
Value& startOf(Value& document, const Override& change, std::string& rest)
{
    auto& table = std::get<Table>(document.data);
    const std::string first = split(change.path).front();
    if (std::ranges::find(sceneKeys(), first) != sceneKeys().end()) {
        createSection(table, first, change.place);
        return document;
    }
    std::vector<std::string> known = sceneKeys();
    Value* nearest = nullptr;
    std::size_t longest = 0;
    for (const auto& [name, object] : namedObjects(table)) {
        known.push_back(name);
        if (name.size() > longest && change.path.starts_with(name + ".")) {
            nearest = object;
            longest = name.size();
        }
    }
    if (!nearest)
        leadsNowhere(change, fmt::format("the scene has no '{}'", first), first, known);
    rest = change.path.substr(longest + 1);
    return *nearest;
}

Value& stepInto(Value& value, const std::string& step, const Override& change)
{
    if (auto* array = std::get_if<Array>(&value.data))
        return elementOf(*array, step, change);
    auto* table = std::get_if<Table>(&value.data);
    if (!table)
        fail(ExitCode::usage, change.place, fmt::format("'{}' leads into {}", step, inWords(value)),
             "end the path before it");
    Value* next = find(*table, step);
    if (!next)
        leadsNowhere(change, fmt::format("there is no '{}'", step), step, keysOf(*table));
    return *next;
}

void set(Value& value, const std::string& key, const Override& change)
{
    auto* table = std::get_if<Table>(&value.data);
    if (table && !find(*table, key))
        table->entries.push_back({key, change.place, change.value});
    else
        stepInto(value, key, change) = change.value;
}

// The kinds of sky exclude each other, and only a picture can be turned: the new kind takes the place of the
// old.
void dropOtherSkies(Value& document, const std::string& path)
{
    for (std::string_view kind : {"colour", "gradient", "image"}) {
        if (path != "sky." + std::string(kind))
            continue;
        Value& sky = *find(std::get<Table>(document.data), "sky");
        std::erase_if(std::get<Table>(sky.data).entries, [&](const Entry& entry) {
            const std::string& key = entry.key;
            const bool isKind = key == "colour" || key == "gradient" || key == "image";
            const bool ofPictures = key == "encoding" || key == "rotation_deg" || key == "mirror_u";
            return (isKind && key != kind) || (ofPictures && kind != "image");
        });
    }
}

void apply(Value& document, const Override& change)
{
    std::string rest = change.path;
    Value* value = &startOf(document, change, rest);
    const std::vector<std::string> steps = split(rest);
    for (std::size_t i = 0; i + 1 < steps.size(); ++i)
        value = &stepInto(*value, steps[i], change);
    set(*value, steps.back(), change);
    dropOtherSkies(document, change.path);
}

} // namespace

void applyOverrides(Value& document, const std::vector<std::string>& overrides)
{
    for (const std::string& text : overrides)
        apply(document, parse(text));
}

// Quotes open in values alone: a path may hold an object's name with an apostrophe.
std::vector<std::string> splitOverrides(const std::string& text)
{
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = '\0';
    bool inValue = false;
    for (const char letter : text) {
        if (quote != '\0') {
            quote = letter == quote ? '\0' : quote;
        } else if (letter == ',' && depth == 0) {
            parts.emplace_back();
            inValue = false;
            continue;
        } else if (inValue && (letter == '"' || letter == '\'')) {
            quote = letter;
        } else if (letter == '[' || letter == ']') {
            depth += letter == '[' ? 1 : -1;
        }
        inValue = inValue || letter == '=';
        parts.back() += letter;
    }
    return parts;
}

} // namespace dioptre
