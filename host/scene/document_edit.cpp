#include "scene/document_edit.h"

#include "base/text.h"
#include "scene/override.h"
#include "scene/text_places.h"
#include "scene/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace dioptre
{
namespace
{

[[noreturn]] void refuseToWrite(const Value& value, const std::string& what)
{
    fail(ExitCode::badInput, value.where, what, "change the file by hand");
}

// The values from the root down the steps, as far as they are there.
std::vector<const Value*> chainTo(const Value& document, const Steps& steps)
{
    std::vector<const Value*> chain{&document};
    for (const std::string& step : steps) {
        const Value& last = *chain.back();
        const Value* next = nullptr;
        if (const auto* array = std::get_if<Array>(&last.data))
            next = &array->at(std::stoul(step));
        else if (const auto* table = std::get_if<Table>(&last.data))
            next = find(*table, step);
        if (next == nullptr)
            break;
        chain.push_back(next);
    }
    return chain;
}

// How a table is written: {…}, under a header of its own, or as the first parts of dotted keys.
enum class Form { inlined, headed, dotted };

struct Insertion {
    std::size_t begin; // of what it takes the place of
    std::size_t end;
    std::string text;
};

// One value written into one text, of which `document` is what it says.
class Writing
{
public:
    Writing(const std::string& text, const Value& document) : text_(text), document_(document), places_(text)
    {
    }

    std::string withValue(const Steps& steps, const Value& value)
    {
        const auto chain = chainTo(document_, steps);
        if (chain.size() > steps.size())
            replace(*chain.back(), value);
        else if (chain.size() == steps.size() && !isImplied(*chain.back()))
            add(chain, steps, keyText(steps.back()) + " = " + valueText(value));
        else
            append(steps, valueText(value));
        return applied();
    }

    // Without the `at`-th entry of a table.
    std::string without(const Table& table, std::size_t at, bool isInlined)
    {
        const Entry& entry = table.entries[at];
        if (!isWritten(entry))
            refuseToWrite(entry.value, fmt::format("{} has keys of its own", entry.key));
        const std::size_t end = places_.endOf(entry.value);
        if (!isInlined)
            eraseLine(places_.keyOf(entry), end);
        else if (at > 0)
            changes_.push_back({places_.endOf(table.entries[at - 1].value), end, ""});
        else
            changes_.push_back(
                {places_.keyOf(entry), table.entries.size() > 1 ? places_.keyOf(table.entries[1]) : end, ""});
        return applied();
    }

    Form formOf(const Value& table) const
    {
        if (&table == &document_)
            return Form::headed;
        const char first = text_.at(places_.beginOf(table));
        return first == '{' ? Form::inlined : first == '[' ? Form::headed : Form::dotted;
    }

private:
    // Whether the entry's value stands behind its key: not as a table of headers or of dotted keys. A header
    // may follow those of the tables within it.
    bool isWritten(const Entry& entry) const
    {
        const bool isTable = std::holds_alternative<Table>(entry.value.data);
        return places_.beginOf(entry.value) > places_.keyOf(entry) &&
               (!isTable || formOf(entry.value) == Form::inlined);
    }

    // Whether a table has no header but those of tables within it: [material.glass] makes `material`.
    bool isImplied(const Value& table) const
    {
        const auto& entries = std::get<Table>(table.data).entries;
        return &table != &document_ && formOf(table) == Form::headed &&
               std::ranges::any_of(entries, [&](const Entry& entry) {
                   return places_.beginOf(entry.value) == places_.beginOf(table);
               });
    }

    // The entry whose value ends last of those that belong to the table's own lines; null where it has none.
    const Entry* lastOf(const Table& table) const
    {
        const Entry* last = nullptr;
        for (const Entry& entry : table.entries) {
            const Entry* candidate = isWritten(entry) ? &entry : nullptr;
            if (const auto* within = std::get_if<Table>(&entry.value.data);
                within && candidate == nullptr && formOf(entry.value) == Form::dotted)
                candidate = lastOf(*within);
            if (candidate && (!last || places_.endOf(candidate->value) > places_.endOf(last->value)))
                last = candidate;
        }
        return last;
    }

    void replace(const Value& old, const Value& value)
    {
        if (saySame(old, value))
            return;
        const auto* olds = std::get_if<Array>(&old.data);
        const auto* news = std::get_if<Array>(&value.data);
        const bool underHeaders =
            olds && !olds->empty() && places_.beginOf(olds->front()) == places_.beginOf(old);
        const bool isTable = std::holds_alternative<Table>(old.data);
        if (underHeaders || (isTable && formOf(old) != Form::inlined))
            refuseToWrite(old, "a value cannot take the place of tables with keys of their own");
        if (!olds || !news || olds->size() != news->size()) {
            changes_.push_back({places_.beginOf(old), places_.endOf(old), valueText(value, &old)});
            return;
        }
        for (std::size_t i = 0; i < olds->size(); ++i)
            replace((*olds)[i], (*news)[i]);
    }

    // `chain` leads to the table that gets the assignment. In a table of dotted keys it starts with them.
    void add(const std::vector<const Value*>& chain, const Steps& steps, std::string assignment)
    {
        std::size_t owner = chain.size() - 1;
        for (; formOf(*chain[owner]) == Form::dotted; --owner)
            assignment = keyText(steps[owner - 1]) + "." + assignment;
        const Entry* last = lastOf(std::get<Table>(chain.back()->data));
        if (formOf(*chain[owner]) == Form::inlined) {
            const std::size_t at = last ? places_.endOf(last->value) : places_.beginOf(*chain[owner]) + 1;
            changes_.push_back({at, at, (last ? ", " : "") + assignment});
        } else if (last) {
            addLine(places_.endOf(last->value), places_.indentAt(places_.keyOf(*last)) + assignment);
        } else if (owner == 0) {
            changes_.push_back({places_.first(), places_.first(), assignment + places_.lineBreak()});
        } else {
            const std::size_t header = places_.beginOf(*chain[owner]);
            addLine(header, places_.indentAt(header) + assignment);
        }
    }

    // A section that has no header in the text, with its one key.
    void append(const Steps& steps, const std::string& value)
    {
        std::string header;
        for (std::size_t i = 0; i + 1 < steps.size(); ++i)
            header += (i == 0 ? "" : ".") + keyText(steps[i]);
        const std::string& end = places_.lineBreak();
        const bool isEmpty = text_.size() == places_.first();
        const std::string before = isEmpty ? "" : text_.ends_with('\n') ? end : end + end;
        changes_.push_back(
            {text_.size(), text_.size(),
             fmt::format("{}[{}]{}{} = {}{}", before, header, end, keyText(steps.back()), value, end)});
    }

    // Behind the line that holds the offset.
    void addLine(std::size_t behind, const std::string& line)
    {
        const std::size_t at = places_.lineEnd(behind);
        const bool ends = at > 0 && text_[at - 1] == '\n';
        changes_.push_back({at, at, ends ? line + places_.lineBreak() : places_.lineBreak() + line});
    }

    // A comment behind the value stays, as a line of its own.
    void eraseLine(std::size_t key, std::size_t end)
    {
        const std::size_t start = places_.lineStart(key), next = places_.lineEnd(end);
        const std::size_t rest = std::min(text_.find_first_not_of(" \t\r\n", end), next);
        if (rest == next)
            changes_.push_back({start, next, ""});
        else
            changes_.push_back({start + places_.indentAt(key).size(), rest, ""});
    }

    std::string applied()
    {
        std::string result = text_;
        std::ranges::sort(changes_, std::greater<>(), &Insertion::begin);
        for (const Insertion& change : changes_)
            result.replace(change.begin, change.end - change.begin, change.text);
        changes_.clear();
        return result;
    }

    const std::string& text_;
    const Value& document_;
    TextPlaces places_;
    std::vector<Insertion> changes_;
};

const Table* skyOf(const Value& document)
{
    const Value* sky = find(std::get<Table>(document.data), "sky");
    return sky ? std::get_if<Table>(&sky->data) : nullptr;
}

// A new kind of sky drops keys of the old: the first that is still in the text.
std::optional<std::size_t> droppedKey(const Table* written, const Table* wanted)
{
    if (!written || !wanted)
        return std::nullopt;
    for (std::size_t i = 0; i < written->entries.size(); ++i)
        if (!find(*wanted, written->entries[i].key))
            return i;
    return std::nullopt;
}

[[noreturn]] void refuseText(const std::string& path, const std::string& override)
{
    fail(ExitCode::badInput, {path}, fmt::format("{} cannot be written into it as it stands", override),
         "change the file by hand");
}

// A text that was written here: that it is no TOML any more is no fault of its author's.
Value parseWritten(const std::string& text, const std::string& path, const std::string& override)
{
    try {
        return parseDocument(text, path);
    } catch (const Error&) {
        refuseText(path, override);
    }
}

std::string withOne(std::string text, const std::string& path, const std::string& override)
{
    const Value document = parseDocument(text, path);
    Value wanted = document;
    const Steps steps = applyOverrides(wanted, {override}).front().steps;
    text = Writing(text, document).withValue(steps, *chainTo(wanted, steps).back());
    while (true) {
        const Value now = parseWritten(text, path, override);
        const Table* sky = skyOf(now);
        const auto dropped = droppedKey(sky, skyOf(wanted));
        if (!dropped)
            return text;
        Writing writing(text, now);
        const bool isInlined = writing.formOf(*find(std::get<Table>(now.data), "sky")) == Form::inlined;
        text = writing.without(*sky, *dropped, isInlined);
    }
}

} // namespace

std::string withValues(const std::string& text, const std::string& path,
                       const std::vector<std::string>& overrides)
{
    Value wanted = parseDocument(text, path);
    applyOverrides(wanted, overrides);
    std::string result = text;
    for (const std::string& override : overrides)
        result = withOne(result, path, override);
    if (!saySame(parseWritten(result, path, join(overrides, ", ")), wanted))
        refuseText(path, join(overrides, ", "));
    return result;
}

} // namespace dioptre
