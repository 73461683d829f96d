#include "render/endless_loop.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace dioptre
{
namespace
{

// Where the statement at `first` ends. One without braces may go on behind its first semicolon: all that
// follows in its block counts.
std::size_t afterStatement(const std::vector<ShaderToken>& all, std::size_t first)
{
    if (first < all.size() && all[first].text == "{")
        return afterBracket(all, first);
    int depth = 0;
    std::size_t i = first;
    if (i < all.size() && all[i].text == ";")
        return i + 1;
    for (; i < all.size() && depth >= 0; ++i)
        depth += all[i].text == "{" ? 1 : all[i].text == "}" ? -1 : 0;
    return i;
}

// Of the brackets at `open`: the condition of a while, or what stands between a for's semicolons.
bool alwaysTrue(const std::vector<ShaderToken>& all, std::size_t open, bool isFor)
{
    std::size_t first = open + 1;
    std::size_t end = afterBracket(all, open) - 1;
    const auto semicolon = [&](std::size_t from) {
        while (from < end && all[from].text != ";")
            ++from;
        return from;
    };
    if (isFor) {
        first = semicolon(first) + 1;
        end = semicolon(first);
    }
    return (isFor && first == end) || (first + 1 == end && all[first].text == "true");
}

// Whether the text that a compiler sees from `first` to `end` hangs on conditionals.
bool isConditional(const std::vector<ShaderToken>& all, std::size_t first, std::size_t end)
{
    return all[first].depth > 0 || all[first].conditionals != all[end - 1].conditionals;
}

bool canLeave(const ShaderTokens& tokens, std::size_t first, std::size_t end)
{
    const std::set<std::string_view> exits = {"break", "return"};
    return std::any_of(tokens.all.begin() + static_cast<std::ptrdiff_t>(first),
                       tokens.all.begin() + static_cast<std::ptrdiff_t>(end), [&](const ShaderToken& token) {
                           return exits.contains(token.text) || tokens.macros.contains(token.text);
                       });
}

} // namespace

void refuseEndlessLoops(const ShaderTokens& tokens)
{
    const auto& all = tokens.all;
    // A function that is called may discard.
    if (std::ranges::any_of(all, [](const ShaderToken& token) { return token.text == "discard"; }))
        return;
    std::set<std::size_t> endsOfDo; // their whiles
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const bool isDo = all[i].text == "do";
        const bool isFor = all[i].text == "for";
        if ((!isDo && !isFor && all[i].text != "while") || endsOfDo.contains(i))
            continue;
        const std::size_t body = isDo ? i + 1 : afterBracket(all, i + 1);
        std::size_t end = afterStatement(all, body);
        std::size_t condition = i + 1;
        if (isDo) {
            while (all[body].text != "{" && end > body && all[end - 1].text != "while")
                --end; // one statement without braces: the last while of the block, at the furthest
            condition = all[body].text == "{" ? end + 1 : end;
            endsOfDo.insert(condition - 1);
        }
        if (condition >= all.size() || all[condition].text != "(" || !alwaysTrue(all, condition, isFor))
            continue;
        if (!isConditional(all, i, std::max(end, condition)) && !canLeave(tokens, body, end))
            fail(ExitCode::badInput, all[i].at, "this loop never ends",
                 "give it a condition, or a break that is reached");
    }
}

} // namespace dioptre
