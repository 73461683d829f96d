#include "render/author_column.h"

#include <algorithm>
#include <set>

namespace dioptre
{
namespace
{

// Behind the blanks and comments that begin at `at`.
std::size_t behindBlanks(std::string_view line, std::size_t at)
{
    while (at < line.size()) {
        if (line[at] == ' ' || line[at] == '\t')
            ++at;
        else if (line.substr(at).starts_with("//"))
            return line.size();
        else if (line.substr(at).starts_with("/*"))
            at = std::min(line.find("*/", at + 2), line.size() - 2) + 2;
        else
            break;
    }
    return at;
}

// Which byte becomes the one at `column` where each run of blanks and comments becomes one blank.
std::size_t beforeCollapse(std::string_view line, int column)
{
    std::size_t at = 0;
    for (int passed = 1; passed < column && at < line.size(); ++passed) {
        const std::size_t behind = behindBlanks(line, at);
        at = behind > at ? behind : at + 1;
    }
    return at;
}

std::set<std::string_view> macrosOf(const SourceText& source)
{
    std::set<std::string_view> macros;
    bool inComment = false;
    for (const auto& line : source) {
        const auto words = identifiers(line.text, inComment);
        if (words.size() > 1 && words[0] == "define")
            macros.insert(words[1]);
    }
    return macros;
}

} // namespace

int authorColumn(const LogMessage& message, const SourceText& source, std::size_t index)
{
    if (message.column == 0 || !message.collapsed)
        return message.column;
    bool inComment = false;
    for (std::size_t i = 0; i < index; ++i)
        identifiers(source[i].text, inComment);
    const std::string_view line = source[index].text;
    const std::size_t at = beforeCollapse(line, message.column);
    const auto before = identifiers(line.substr(0, at), inComment);
    const auto macros = macrosOf(source);
    const bool expands = std::ranges::any_of(before, [&](auto word) { return macros.contains(word); });
    return inComment || expands || at >= line.size() ? 0 : static_cast<int>(at) + 1;
}

} // namespace dioptre
