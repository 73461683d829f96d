#include "render/directive.h"

#include <algorithm>

namespace dioptre
{
namespace
{

std::string_view trimmed(std::string_view text)
{
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

} // namespace

std::optional<Directive> directiveOf(std::string_view line)
{
    line = trimmed(line);
    if (!line.starts_with('#'))
        return std::nullopt;
    line = trimmed(line.substr(1));
    line = trimmed(line.substr(0, line.find("//")));
    const auto end = std::min(line.find_first_of(" \t\"<"), line.size());
    return Directive{line.substr(0, end), trimmed(line.substr(end))};
}

std::optional<std::string> includedName(const Directive& include)
{
    const auto& argument = include.argument;
    if (argument.size() < 2 || argument.front() != '"' || argument.back() != '"')
        return std::nullopt;
    return std::string(argument.substr(1, argument.size() - 2));
}

} // namespace dioptre
