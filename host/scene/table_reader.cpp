#include "scene/table_reader.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{

TableReader::TableReader(const Value& value, std::string name, std::vector<std::string> keys)
    : table_(std::get_if<Table>(&value.data)), where_(value.where), name_(std::move(name))
{
    if (!table_)
        refuse(value, name_, "a table of keys and values");
    for (const Entry& entry : table_->entries)
        if (std::ranges::find(keys, entry.key) == keys.end())
            refuseWord(entry.where, fmt::format("{} has no key '{}'", name_, entry.key), entry.key, keys);
}

const std::string& TableReader::name() const
{
    return name_;
}

const Value* TableReader::find(std::string_view key) const
{
    return dioptre::find(*table_, key);
}

const Table& TableReader::table() const
{
    return *table_;
}

const SourcePosition& TableReader::where() const
{
    return where_;
}

const SourcePosition& TableReader::where(std::string_view key) const
{
    const Value* value = find(key);
    return value ? value->where : where_;
}

void TableReader::require(std::initializer_list<std::string_view> keys) const
{
    for (std::string_view key : keys)
        if (!find(key))
            fail(ExitCode::badInput, where_, fmt::format("{} has no {}", name_, key),
                 fmt::format("add '{} = ...'", key));
}

void TableReader::refuseUnless(bool reason, std::string_view key, std::string_view why,
                               std::string_view mend) const
{
    if (reason)
        return;
    const auto entry = std::ranges::find(table_->entries, key, &Entry::key);
    if (entry != table_->entries.end())
        fail(ExitCode::badInput, entry->where, fmt::format("'{}' has no effect {}", key, why), mend);
}

void TableReader::text(std::string_view key, std::string& target) const
{
    if (const Value* value = find(key))
        target = textFrom(*value, key);
}

void TableReader::flag(std::string_view key, bool& target) const
{
    if (const Value* value = find(key))
        target = flagFrom(*value, key);
}

void TableReader::integer(std::string_view key, std::optional<int>& target, int low, int high) const
{
    if (const Value* value = find(key))
        target = integerFrom(*value, key, low, high);
}

void TableReader::number(std::string_view key, double& target, const Range& range) const
{
    if (const Value* value = find(key))
        target = numberFrom(*value, key, range);
}

void TableReader::vector(std::string_view key, glm::dvec3& target, const Range& range) const
{
    if (const Value* value = find(key))
        target = vectorFrom(*value, key, range);
}

void TableReader::nonZero(std::string_view key, glm::dvec3& target) const
{
    if (const Value* value = find(key))
        target = nonZeroFrom(*value, key);
}

void TableReader::colour(std::string_view key, glm::dvec3& target) const
{
    if (const Value* value = find(key))
        target = colourFrom(*value, key);
}

void TableReader::colour(std::string_view key, std::optional<glm::dvec3>& target) const
{
    if (const Value* value = find(key))
        target = colourFrom(*value, key);
}

std::optional<std::size_t> TableReader::wordIndex(std::string_view key,
                                                  const std::vector<std::string>& words) const
{
    const Value* value = find(key);
    if (!value)
        return std::nullopt;
    const std::string& word = textFrom(*value, key, fmt::format("one of the strings {}", join(words, ", ")));
    const auto known = std::ranges::find(words, word);
    if (known == words.end())
        refuseWord(value->where, fmt::format("{} is \"{}\"", key, word), word, words);
    return static_cast<std::size_t>(known - words.begin());
}

} // namespace dioptre
