// A TOML table read key by key into the fields of a struct; keys that nobody would read are refused first.
#pragma once

#include "scene/choices.h"
#include "scene/value_reader.h"

#include <initializer_list>
#include <optional>
#include <span>
#include <utility>

namespace dioptre
{

class TableReader
{
public:
    // `name` is what messages call the table, such as "[camera]". Throws badInput for a value that is not a
    // table and for a key that is not in `keys`. The value must outlive the reader.
    TableReader(const Value& value, std::string name, std::vector<std::string> keys);

    const std::string& name() const;
    const Value* find(std::string_view key) const; // null where unset
    const Table& table() const;
    const SourcePosition& where() const;
    const SourcePosition& where(std::string_view key) const; // of the key's value; of the table where unset

    // Throws badInput for the first of the keys that is unset.
    void require(std::initializer_list<std::string_view> keys) const;

    // Throws badInput where `key` is set and `reason` is not: the value would have no effect.
    void refuseUnless(bool reason, std::string_view key, std::string_view why, std::string_view mend) const;

    // Each leaves the target alone where the key is unset.
    void text(std::string_view key, std::string& target) const;
    void flag(std::string_view key, bool& target) const;
    void integer(std::string_view key, std::optional<int>& target, int low, int high) const;
    void number(std::string_view key, double& target, const Range& range) const;
    void vector(std::string_view key, glm::dvec3& target, const Range& range = anyNumber) const;
    void nonZero(std::string_view key, glm::dvec3& target) const;
    void colour(std::string_view key, glm::dvec3& target) const;
    void colour(std::string_view key, std::optional<glm::dvec3>& target) const;

    template <class Choice>
    using Names = std::initializer_list<std::pair<std::string_view, Choice>>;

    // One of a few words.
    template <class Choice>
    void choice(std::string_view key, Choice& target, Names<Choice> names) const
    {
        std::vector<std::string> words;
        for (const auto& [word, choice] : names)
            words.emplace_back(word);
        if (const std::optional<std::size_t> index = wordIndex(key, words))
            target = std::data(names)[*index].second;
    }

    // The same from a table of names that others read as well.
    template <class Choice>
    void choice(std::string_view key, Choice& target, std::span<const NamedChoice<Choice>> table) const
    {
        std::vector<std::string> words;
        for (const auto& entry : table)
            words.emplace_back(entry.name);
        if (const std::optional<std::size_t> index = wordIndex(key, words))
            target = table[*index].choice;
    }

private:
    // Which of the words the key has; nothing where it is unset.
    std::optional<std::size_t> wordIndex(std::string_view key, const std::vector<std::string>& words) const;

    const Table* table_;
    SourcePosition where_;
    std::string name_;
};

} // namespace dioptre
