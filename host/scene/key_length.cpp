#include "scene/key_length.h"

#include <algorithm>
#include <cctype>

namespace dioptre
{
namespace
{

// Behind the string that begins at `at`: "…" and '…' end with their line, """…""" and '''…''' do not.
std::size_t endOfString(std::string_view text, std::size_t at)
{
    const char quote = text[at];
    const std::size_t quotes = text.substr(at, 3) == std::string(3, quote) ? 3 : 1;
    const std::string close(quotes, quote);
    for (at += quotes; at < text.size(); ++at) {
        if (quote == '"' && text[at] == '\\')
            ++at;
        else if (text.substr(at, quotes) == close)
            return at + quotes;
        else if (quotes == 1 && text[at] == '\n')
            return at;
    }
    return text.size();
}

SourcePosition placeOf(std::string_view text, std::size_t at)
{
    const auto before = text.substr(0, at);
    const auto lineStart = before.rfind('\n') + 1; // 0 where there is none
    return {"", static_cast<int>(std::ranges::count(before, '\n')) + 1, static_cast<int>(at - lineStart) + 1};
}

} // namespace

std::optional<SourcePosition> longKeyIn(std::string_view text, int mostParts)
{
    int parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char letter = text[at];
        if (letter == '"' || letter == '\'') {
            at = endOfString(text, at);
            continue;
        }
        if (letter == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        const bool withinKey = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' ||
                               letter == '-' || letter == ' ' || letter == '\t' || letter == '.';
        parts = withinKey ? parts + (letter == '.' ? 1 : 0) : 1;
        if (parts > mostParts)
            return placeOf(text, at);
        ++at;
    }
    return std::nullopt;
}

} // namespace dioptre
