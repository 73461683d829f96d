#include "render/annotation.h"
#include "render/literal.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// A piece of the file and what takes its place.
struct Replacement {
    std::size_t at = 0; // byte
    std::size_t count = 0;
    std::string text;
};

// By line: its first byte in the file.
std::vector<std::size_t> beginsOf(const std::string& fileText, const SourceText& lines)
{
    std::vector<std::size_t> begins;
    std::size_t at = fileText.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (const auto& line : lines) {
        begins.push_back(at);
        at += line.text.size();
        at += fileText.compare(at, 2, "\r\n") == 0 ? 2 : 1;
    }
    return begins;
}

// A number of the type, as a comment has it: the nearest float's shortest text.
std::string numberText(const std::string& type, double number)
{
    if (type.front() == 'b')
        return number != 0.0 ? "true" : "false";
    return fmt::format("{}", static_cast<float>(number));
}

// "#ff8800" where the bytes say the same.
std::optional<std::string> colourText(const std::vector<double>& numbers)
{
    std::string text = "#";
    for (const double number : numbers) {
        const double byte = std::round(255.0 * number);
        if (byte < 0.0 || byte > 255.0 || std::abs(byte / 255.0 - number) > 1e-6)
            return std::nullopt;
        text += fmt::format("{:02x}", static_cast<int>(byte));
    }
    return text;
}

std::string commentText(const Annotation& annotation, const std::vector<double>& numbers, bool asColour)
{
    if (asColour)
        if (const auto colour = colourText(numbers))
            return *colour;
    std::vector<std::string> words;
    for (const double number : numbers)
        words.push_back(numberText(annotation.type, number));
    return words.size() == 1 ? words.front() : "[" + join(words, ", ") + "]";
}

std::string declaredText(const Annotation& annotation, const std::vector<double>& numbers)
{
    const char first = annotation.type.front();
    const bool floats = annotation.type == "float" || first == 'v';
    std::vector<std::string> words;
    for (const double number : numbers)
        words.push_back(floats ? literal(number)
                               : numberText(annotation.type, number) + (first == 'u' ? "u" : ""));
    return words.size() == 1 ? words.front() : annotation.type + "(" + join(words, ", ") + ")";
}

std::vector<Replacement> replacementsOf(const std::string& fileText,
                                        const std::map<std::string, std::vector<double>>& values)
{
    const SourceText lines = linesOf(fileText, "shader");
    const auto begins = beginsOf(fileText, lines);
    std::vector<Replacement> replacements;
    for (const auto& annotation : annotationsOf(lines)) {
        const auto value = values.find(annotation.name);
        if (value == values.end())
            continue;
        const std::size_t begin = begins[static_cast<std::size_t>(annotation.where.line) - 1];
        const auto add = [&](const ValueColumns& columns, const auto& textOf) {
            const std::size_t at = begin + static_cast<std::size_t>(columns.first) - 1;
            const auto count = static_cast<std::size_t>(columns.count);
            replacements.push_back({at, count, textOf(fileText[at] == '#')});
        };
        if (annotation.inDeclaration)
            add(*annotation.inDeclaration, [&](bool) { return declaredText(annotation, value->second); });
        if (annotation.inComment)
            add(*annotation.inComment,
                [&](bool colour) { return commentText(annotation, value->second, colour); });
    }
    return replacements;
}

} // namespace

std::string withDefaults(const std::string& fileText,
                         const std::map<std::string, std::vector<double>>& values)
{
    auto replacements = replacementsOf(fileText, values);
    std::ranges::sort(replacements, {}, &Replacement::at);
    std::string text;
    std::size_t at = 0;
    for (const auto& replacement : replacements) {
        text += fileText.substr(at, replacement.at - at) + replacement.text;
        at = replacement.at + replacement.count;
    }
    return text + fileText.substr(at);
}

} // namespace dioptre
