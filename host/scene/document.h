// A TOML text as a tree of our own: in file order, every node with its place; the only door to the TOML
// library.
#pragma once

#include "base/error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dioptre
{

struct Value;
struct Entry;

using Array = std::vector<Value>;

struct Table {
    std::vector<Entry> entries; // in file order; keys are unique
};

// A date or a time: TOML has them, no scene wants one.
struct Moment {
};

// Counted from 1, columns in code points.
struct TextPlace {
    int line = 0;
    int column = 0;
};

struct Value {
    std::variant<std::string, std::int64_t, double, bool, Moment, Array, Table> data;
    SourcePosition where; // of a table under a header the header's
    TextPlace end{};      // behind its last character; 0 in a value that no file holds
};

struct Entry {
    std::string key;
    SourcePosition where; // of the key
    Value value;
};

// The value under `key`, or null.
const Value* find(const Table& table, std::string_view key);
Value* find(Table& table, std::string_view key);

// "the string "x"", "the number -1.5", "a table": what was found, for messages.
std::string inWords(const Value& value);

// The whole text as a table. Throws badInput at the library's own position.
Value parseDocument(const std::string& text, const std::string& path);

// One value written in TOML, all of it placed at `where`; nothing when the text is not a value.
std::optional<Value> parseValue(const std::string& text, const SourcePosition& where);

} // namespace dioptre
