#include "render/endless_loop.h"

#include "base/error.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <vector>

namespace dioptre
{
namespace
{

struct Token {
    std::string_view text; // a word, or one sign
    SourcePosition at;
};

// The tokens outside comments and directives, and the names of macros.
struct Tokens {
    std::vector<Token> all;
    std::set<std::string_view> macros;
};

bool isWordLetter(char letter)
{
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

std::size_t endOfWord(std::string_view line, std::size_t begin)
{
    std::size_t end = begin + 1;
    while (isWordLetter(line[begin]) && end < line.size() && isWordLetter(line[end]))
        ++end;
    return end;
}

void addTokens(Tokens& tokens, const SourceLine& line, bool& inComment)
{
    const std::string_view text = line.text;
    for (std::size_t i = 0; i < text.size();) {
        if (inComment) {
            const auto end = text.find("*/", i);
            inComment = end == std::string_view::npos;
            i = inComment ? text.size() : end + 2;
        } else if (text.substr(i).starts_with("//")) {
            return;
        } else if (text.substr(i).starts_with("/*")) {
            inComment = true;
            i += 2;
        } else {
            const std::size_t end = endOfWord(text, i);
            if (std::isspace(static_cast<unsigned char>(text[i])) == 0)
                tokens.all.push_back(
                    {text.substr(i, end - i), {line.file, line.line, static_cast<int>(i) + 1}});
            i = end;
        }
    }
}

Tokens tokensOf(const SourceText& source)
{
    Tokens tokens;
    bool inComment = false;
    bool inDirective = false; // one goes on in the next line after a backslash
    for (const auto& line : source) {
        const auto first = line.text.find_first_not_of(" \t");
        inDirective = inDirective || (!inComment && first != std::string::npos && line.text[first] == '#');
        if (!inDirective) {
            addTokens(tokens, line, inComment);
            continue;
        }
        const auto words = identifiers(line.text, inComment);
        if (words.size() > 1 && words[0] == "define")
            tokens.macros.insert(words[1]);
        inDirective = line.text.ends_with('\\');
    }
    return tokens;
}

// The place after the bracket that closes the one at `open`, or the end.
std::size_t afterBracket(const std::vector<Token>& all, std::size_t open)
{
    int depth = 0;
    for (std::size_t i = open; i < all.size(); ++i) {
        const char sign = all[i].text.front();
        depth += sign == '(' || sign == '{' ? 1 : sign == ')' || sign == '}' ? -1 : 0;
        if (depth == 0)
            return i + 1;
    }
    return all.size();
}

// Where the statement at `first` ends. One without braces may go on behind its first semicolon: all that
// follows in its block counts.
std::size_t afterStatement(const std::vector<Token>& all, std::size_t first)
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
bool alwaysTrue(const std::vector<Token>& all, std::size_t open, bool isFor)
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

bool canLeave(const Tokens& tokens, std::size_t first, std::size_t end)
{
    const std::set<std::string_view> exits = {"break", "return", "discard"};
    return std::any_of(tokens.all.begin() + static_cast<std::ptrdiff_t>(first),
                       tokens.all.begin() + static_cast<std::ptrdiff_t>(end), [&](const Token& token) {
                           return exits.contains(token.text) || tokens.macros.contains(token.text);
                       });
}

} // namespace

void refuseEndlessLoops(const SourceText& source)
{
    const Tokens tokens = tokensOf(source);
    const auto& all = tokens.all;
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
        if (!canLeave(tokens, body, end))
            fail(ExitCode::badInput, all[i].at, "this loop never ends",
                 "give it a condition, or a break that is reached");
    }
}

} // namespace dioptre
