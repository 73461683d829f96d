#include "scene/override.h"

#include <algorithm>

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

} // namespace

std::vector<Overridden> applyOverrides(Value& document, const std::vector<std::string>& overrides)
{
    std::vector<Overridden> done;
    for (const std::string& text : overrides) {
        const Override change = parse(text);
        const Steps steps = resolve(document, {change.path, change.place, ExitCode::usage});
        setAt(document, steps, change.value, change.place);
        dropOtherSkies(document, change.path);
        done.push_back({change.place, steps});
    }
    return done;
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
