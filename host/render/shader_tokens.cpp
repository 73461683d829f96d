#include "render/shader_tokens.h"

#include <cctype>

namespace dioptre
{
namespace
{

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

// `place`: of the line and the conditionals.
void addTokens(ShaderTokens& tokens, const SourceLine& line, const ShaderToken& place, bool& inComment)
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
                tokens.all.push_back({text.substr(i, end - i),
                                      {line.file, line.line, static_cast<int>(i) + 1},
                                      place.conditionals,
                                      place.depth,
                                      place.line});
            i = end;
        }
    }
}

// Counts a directive's words.
void countConditional(std::string_view word, ShaderToken& place)
{
    const bool opens = word == "if" || word == "ifdef" || word == "ifndef";
    const bool closes = word == "endif";
    place.conditionals += opens || closes || word == "else" || word == "elif" ? 1 : 0;
    place.depth += opens ? 1 : closes ? -1 : 0;
}

} // namespace

ShaderTokens tokensOf(const SourceText& source)
{
    ShaderTokens tokens;
    ShaderToken place;
    bool inComment = false;
    bool inDirective = false; // one goes on in the next line after a backslash
    for (const auto& line : source) {
        const auto first = line.text.find_first_not_of(" \t");
        const bool begins =
            !inDirective && !inComment && first != std::string::npos && line.text[first] == '#';
        inDirective = inDirective || begins;
        if (!inDirective) {
            place.line = static_cast<std::size_t>(&line - source.data());
            addTokens(tokens, line, place, inComment);
            continue;
        }
        const auto words = identifiers(line.text, inComment);
        if (begins && words.size() > 1 && words[0] == "define")
            tokens.macros.insert(words[1]);
        if (begins && !words.empty())
            countConditional(words[0], place);
        inDirective = line.text.ends_with('\\');
    }
    return tokens;
}

// The place after the bracket that closes the one at `open`, or the end.
std::size_t afterBracket(const std::vector<ShaderToken>& all, std::size_t open)
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

} // namespace dioptre
