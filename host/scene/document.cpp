#include "scene/document.h"

// The library's assertions fire on faults of the text that it reports properly two lines later ("[{a}]" is
// one), and under NDEBUG clang would take them for promises: neither here.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "scene/key_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace dioptre
{

namespace
{

// The library bounds how deep values nest, and not how many parts a dotted key has: they become tables in one
// another until the stack ends. No scene's key has more than three.
constexpr int mostKeyParts = 16;

SourcePosition positionOf(const toml::source_region& region, const std::string& path)
{
    return {path, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Value valueFrom(const toml::node& node, const std::string& path);

// The library keeps its tables sorted by key; the places give the author's order back.
Table tableFrom(const toml::table& source, const std::string& path)
{
    Table table;
    for (const auto& [key, node] : source)
        table.entries.push_back(
            {std::string(key.str()), positionOf(key.source(), path), valueFrom(node, path)});
    std::ranges::stable_sort(table.entries, {}, [](const Entry& entry) {
        return std::tuple(entry.where.line, entry.where.column);
    });
    return table;
}

Array arrayFrom(const toml::array& source, const std::string& path)
{
    Array array;
    for (const toml::node& node : source)
        array.push_back(valueFrom(node, path));
    return array;
}

Value valueFrom(const toml::node& node, const std::string& path)
{
    const toml::source_position end = node.source().end;
    Value value{Moment{},
                positionOf(node.source(), path),
                {static_cast<int>(end.line), static_cast<int>(end.column)}};
    if (const auto* text = node.as_string())
        value.data = text->get();
    else if (const auto* integer = node.as_integer())
        value.data = integer->get();
    else if (const auto* number = node.as_floating_point())
        value.data = number->get();
    else if (const auto* flag = node.as_boolean())
        value.data = flag->get();
    else if (const auto* array = node.as_array())
        value.data = arrayFrom(*array, path);
    else if (const auto* table = node.as_table())
        value.data = tableFrom(*table, path);
    return value;
}

void placeAt(Value& value, const SourcePosition& where)
{
    value.where = where;
    if (auto* array = std::get_if<Array>(&value.data))
        for (Value& element : *array)
            placeAt(element, where);
    if (auto* table = std::get_if<Table>(&value.data))
        for (Entry& entry : table->entries) {
            entry.where = where;
            placeAt(entry.value, where);
        }
}

struct Wording {
    std::string operator()(const std::string& text) const
    {
        return fmt::format("the string \"{}\"", text);
    }
    std::string operator()(std::int64_t number) const
    {
        return fmt::format("the number {}", number);
    }
    std::string operator()(double number) const
    {
        return fmt::format("the number {}", number);
    }
    std::string operator()(bool flag) const
    {
        return flag ? "true" : "false";
    }
    std::string operator()(const Moment&) const
    {
        return "a date or time";
    }
    std::string operator()(const Array& array) const
    {
        return fmt::format("an array of {}", array.size());
    }
    std::string operator()(const Table&) const
    {
        return "a table";
    }
};

} // namespace

const Value* find(const Table& table, std::string_view key)
{
    const auto entry = std::ranges::find(table.entries, key, &Entry::key);
    return entry == table.entries.end() ? nullptr : &entry->value;
}

Value* find(Table& table, std::string_view key)
{
    const auto entry = std::ranges::find(table.entries, key, &Entry::key);
    return entry == table.entries.end() ? nullptr : &entry->value;
}

std::string inWords(const Value& value)
{
    return std::visit(Wording{}, value.data);
}

Value parseDocument(const std::string& text, const std::string& path)
{
    if (const auto place = longKeyIn(text, mostKeyParts))
        fail(ExitCode::badInput, {path, place->line, place->column},
             fmt::format("a key of more than {} parts", mostKeyParts), "mend the TOML at this place");
    try {
        const toml::table source = toml::parse(std::string_view(text));
        return {tableFrom(source, path), {path}};
    } catch (const toml::parse_error& error) {
        fail(ExitCode::badInput, positionOf(error.source(), path), error.description(),
             "mend the TOML at this place");
    }
}

std::optional<Value> parseValue(const std::string& text, const SourcePosition& where)
{
    if (longKeyIn(text, mostKeyParts))
        return std::nullopt;
    try {
        const toml::table source = toml::parse("value = " + text);
        if (source.size() != 1) // the text went on to a second line with a key of its own
            return std::nullopt;
        Value value = valueFrom(source.begin()->second, "");
        placeAt(value, where);
        return value;
    } catch (const toml::parse_error&) {
        return std::nullopt;
    }
}

} // namespace dioptre
