#include "render/endless_loop.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

namespace dioptre
{
namespace
{

// Where things end, by token, found in one pass each: loops within loops would ask for the same ends over and
// over.
struct Ends {
    std::vector<std::size_t> bracket;   // after the one that closes that (or {; of another token after itself
    std::vector<std::size_t> block;     // after the } that ends the block around it
    std::vector<std::size_t> semicolon; // at the next, itself included
    std::vector<std::size_t> whileBefore; // after the last "while" before it, 0 for none
    std::vector<std::size_t> exitsBefore; // how many tokens before it may leave a loop
};

bool mayLeave(const ShaderTokens& tokens, std::string_view text)
{
    return text == "break" || text == "return" || tokens.macros.contains(text);
}

Ends endsOf(const ShaderTokens& tokens)
{
    const auto& all = tokens.all;
    const std::size_t size = all.size();
    Ends ends;
    for (auto* places : {&ends.bracket, &ends.block, &ends.semicolon})
        places->assign(size + 1, size);
    ends.whileBefore.assign(size + 1, 0);
    ends.exitsBefore.assign(size + 1, 0);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < size; ++i) {
        const std::string_view text = all[i].text;
        const bool opens = text == "(" || text == "{";
        if (opens) {
            open.push_back(i);
        } else if ((text == ")" || text == "}") && !open.empty()) {
            ends.bracket[open.back()] = i + 1;
            open.pop_back();
        }
        if (!opens)
            ends.bracket[i] = i + 1;
        ends.whileBefore[i + 1] = text == "while" ? i + 1 : ends.whileBefore[i];
        ends.exitsBefore[i + 1] = ends.exitsBefore[i] + (mayLeave(tokens, text) ? 1 : 0);
    }
    std::vector<std::size_t> blocks;
    for (std::size_t i = size; i-- > 0;) {
        const std::string_view text = all[i].text;
        if (text == "}")
            blocks.push_back(i + 1);
        else if (text == "{" && !blocks.empty())
            blocks.pop_back();
        ends.block[i] = blocks.empty() ? size : blocks.back();
        ends.semicolon[i] = text == ";" ? i : ends.semicolon[i + 1];
    }
    return ends;
}

// Where the statement at `first` ends. One without braces may go on behind its first semicolon: all that
// follows in its block counts.
std::size_t afterStatement(const std::vector<ShaderToken>& all, const Ends& ends, std::size_t first)
{
    if (first < all.size() && all[first].text == "{")
        return ends.bracket[first];
    if (first < all.size() && all[first].text == ";")
        return first + 1;
    return ends.block[first];
}

// Of the brackets at `open`: the condition of a while, or what stands between a for's semicolons.
bool alwaysTrue(const std::vector<ShaderToken>& all, const Ends& ends, std::size_t open, bool isFor)
{
    std::size_t first = open + 1;
    std::size_t end = ends.bracket[open] - 1;
    const auto semicolon = [&](std::size_t from) {
        return from < end ? std::min(ends.semicolon[from], end) : from;
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

} // namespace

void refuseEndlessLoops(const ShaderTokens& tokens)
{
    const auto& all = tokens.all;
    // A function that is called may discard.
    if (std::ranges::any_of(all, [](const ShaderToken& token) { return token.text == "discard"; }))
        return;
    const Ends ends = endsOf(tokens);
    std::set<std::size_t> endsOfDo; // their whiles
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const bool isDo = all[i].text == "do";
        const bool isFor = all[i].text == "for";
        if ((!isDo && !isFor && all[i].text != "while") || endsOfDo.contains(i))
            continue;
        const std::size_t body = isDo ? i + 1 : ends.bracket[i + 1];
        std::size_t end = afterStatement(all, ends, body);
        std::size_t condition = i + 1;
        if (isDo) {
            if (all[body].text !=
                "{") // one statement without braces: the last while of the block, at the furthest
                end = std::max(body, ends.whileBefore[end]);
            condition = all[body].text == "{" ? end + 1 : end;
            endsOfDo.insert(condition - 1);
        }
        if (condition >= all.size() || all[condition].text != "(" || !alwaysTrue(all, ends, condition, isFor))
            continue;
        const bool canLeave = ends.exitsBefore[end] > ends.exitsBefore[body];
        if (!isConditional(all, i, std::max(end, condition)) && !canLeave)
            fail(ExitCode::badInput, all[i].at, "this loop never ends",
                 "give it a condition, or a break that is reached");
    }
}

} // namespace dioptre
