#include "render/annotation.h"

#include "gl/uniform.h"
#include "render/number_list.h"
#include "render/shader_tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

using Numbers = UniformType::Numbers;

constexpr std::string_view blanks = " \t";

// A piece of a line, trimmed.
struct Piece {
    std::string_view text;
    int column = 0; // from 1
};

Piece trimmed(const Piece& piece)
{
    const auto first = std::min(piece.text.find_first_not_of(blanks), piece.text.size());
    const auto end = piece.text.find_last_not_of(blanks) + 1;
    return {piece.text.substr(first, end > first ? end - first : 0), piece.column + static_cast<int>(first)};
}

// A uniform's declaration, and what stands behind it.
struct Declaration {
    const UniformType* type = nullptr;
    ShaderToken name;
    Piece value;   // behind the =
    Piece comment; // behind the //
};

// The rest of the token's line behind it.
Piece behind(const SourceText& source, const ShaderToken& token)
{
    const std::string& line = source[token.line].text;
    const auto at = static_cast<std::size_t>(token.text.data() - line.data()) + token.text.size();
    return trimmed({std::string_view(line).substr(at), static_cast<int>(at) + 1});
}

bool isSlider(const UniformType* type)
{
    return type != nullptr && type->numbers != Numbers::matrix && type->numbers != Numbers::sampler;
}

// The declaration behind the "uniform" at `at`, of one name; none for any other.
std::optional<Declaration> declarationAt(const SourceText& source, const std::vector<ShaderToken>& all,
                                         std::size_t at)
{
    const auto word = [&](std::size_t i) { return i < all.size() ? all[i].text : std::string_view(); };
    std::size_t next = at + 1;
    while (word(next) == "highp" || word(next) == "mediump" || word(next) == "lowp")
        ++next;
    Declaration declaration{uniformTypeNamed(word(next)), {}, {}, {}};
    const std::size_t sign = next + 2;
    if (!isSlider(declaration.type) || (word(sign) != ";" && word(sign) != "="))
        return std::nullopt;
    declaration.name = all[next + 1];
    std::size_t end = sign;
    while (end < all.size() && all[end].text != ";")
        ++end;
    if (end == all.size())
        return std::nullopt;
    if (word(sign) == "=" && all[end].at.line == all[sign].at.line) {
        declaration.value = behind(source, all[sign]);
        const auto length = static_cast<std::size_t>(all[end].at.column - declaration.value.column);
        declaration.value = trimmed({declaration.value.text.substr(0, length), declaration.value.column});
    }
    const Piece rest = behind(source, all[end]);
    if (rest.text.starts_with("//") && all[end].at.line == declaration.name.at.line)
        declaration.comment = trimmed({rest.text.substr(2), rest.column + 2});
    return declaration;
}

// "2.0", "3u", "true", "vec3(1.0, 0.5, 0.2)", "vec3(1.0)": as many numbers as the type has.
std::optional<std::vector<double>> literalIn(std::string_view text, const UniformType& type)
{
    const bool vector = type.components > 1;
    if (vector && (!text.starts_with(type.name) || !text.ends_with(')')))
        return std::nullopt;
    if (vector) {
        text = trimmed({text.substr(std::string_view(type.name).size()), 0}).text;
        text = text.starts_with('(') ? text.substr(1, text.size() - 2) : "";
    }
    std::string plain(text);
    if (!plain.empty() && (plain.back() == 'f' || plain.back() == 'F' || plain.back() == 'u'))
        plain.pop_back();
    auto numbers = plain.starts_with('[') ? std::nullopt : numbersIn(plain);
    if (numbers && vector && numbers->size() == 1)
        numbers->resize(static_cast<std::size_t>(type.components), numbers->front());
    if (!numbers || numbers->size() != static_cast<std::size_t>(type.components))
        return std::nullopt;
    return numbers;
}

// The first word of a comment, or what stands in brackets.
Piece firstOf(const Piece& comment)
{
    if (comment.text.starts_with('['))
        return {comment.text.substr(0, std::min(comment.text.find(']'), comment.text.size() - 1) + 1),
                comment.column};
    return {comment.text.substr(0, comment.text.find_first_of(blanks)), comment.column};
}

Piece after(const Piece& all, const Piece& first)
{
    return trimmed({all.text.substr(first.text.size()), all.column + static_cast<int>(first.text.size())});
}

// One number, those in brackets or a colour; "true" and "false" are words but behind a bool.
std::optional<std::vector<double>> valueIn(const Piece& piece, const UniformType& type)
{
    const std::string_view text = piece.text;
    const bool isWord = text == "true" || text == "false";
    const bool isList = text.starts_with('[');
    if ((isWord && type.name[0] != 'b') || (!isList && text.find(',') != std::string_view::npos))
        return std::nullopt;
    const auto numbers = numbersIn(text);
    const bool finite =
        numbers && std::ranges::all_of(*numbers, [](double number) { return std::isfinite(number); });
    return finite ? numbers : std::nullopt;
}

[[noreturn]] void refuse(const Declaration& declaration, const Piece& piece, const std::string& what,
                         const std::string& mend)
{
    const SourcePosition& line = declaration.name.at;
    fail(ExitCode::badInput, {line.path, line.line, piece.column}, fmt::format("{} {}", piece.text, what),
         mend);
}

std::string exampleOf(const UniformType& type)
{
    const std::string name = type.name;
    if (type.components > 1)
        return fmt::format("{} numbers in brackets, as [1, 2] has 2", type.components);
    return name == "bool" ? "true or false" : name == "float" ? "one number" : "one whole number";
}

void takeRange(const Declaration& declaration, const Piece& piece, const std::vector<double>& range,
               Annotation& annotation)
{
    const bool isBool = declaration.type->name[0] == 'b';
    if (range.size() != 2 || isBool)
        refuse(declaration, piece, fmt::format("is no range for type {}", declaration.type->name),
               isBool ? "leave it out" : "write the value, then the least and the greatest: 0.3 [0, 1]");
    if (!(range[0] < range[1]))
        refuse(declaration, piece, "is a range whose lower end is not below its upper one",
               fmt::format("write the lower first: [{}, {}]", std::min(range[0], range[1]),
                           std::max(range[0], range[1])));
    annotation.low = range[0];
    annotation.high = range[1];
}

// A range about values that none is given for: up to their double.
void chooseRange(Annotation& annotation)
{
    double reach = 0.0;
    for (const double number : annotation.defaults)
        reach = std::max(reach, std::abs(number));
    const bool below = std::ranges::any_of(annotation.defaults, [](double number) { return number < 0.0; });
    const bool isBool = annotation.type.front() == 'b';
    annotation.high = reach > 0.0 && !isBool ? 2.0 * reach : 1.0;
    annotation.low = below ? -annotation.high : 0.0;
}

void checkWithin(const Declaration& declaration, const Piece& piece, const std::vector<double>& numbers,
                 const Annotation& annotation)
{
    for (const double number : numbers)
        if (number < annotation.low || number > annotation.high)
            refuse(declaration, piece,
                   fmt::format("is outside the range [{}, {}]", annotation.low, annotation.high),
                   "widen the range, or start within it");
}

// What the comment says; nothing where it is free text.
void readComment(const Declaration& declaration, Annotation& annotation)
{
    const UniformType& type = *declaration.type;
    const Piece value = firstOf(declaration.comment);
    const auto numbers = valueIn(value, type);
    if (!numbers)
        return;
    const Piece rest = after(declaration.comment, value);
    const Piece bracketed = firstOf(rest);
    const auto range = rest.text.starts_with('[') ? numbersIn(bracketed.text) : std::nullopt;
    const bool fitting = numbers->size() == static_cast<std::size_t>(type.components) &&
                         std::ranges::all_of(*numbers, [&](double number) { return fits(type, number); });
    const bool bare = !value.text.starts_with('[') && !value.text.starts_with('#') && !range;
    if (!fitting && bare)
        return;
    if (!fitting)
        refuse(declaration, value, fmt::format("is no value of type {}", type.name),
               "give " + exampleOf(type));
    annotation.inComment = ValueColumns{value.column, static_cast<int>(value.text.size())};
    if (!annotation.inDeclaration)
        annotation.defaults = *numbers;
    annotation.label = range ? after(rest, bracketed).text : rest.text;
    if (range) {
        takeRange(declaration, bracketed, *range, annotation);
        checkWithin(declaration, value, *numbers, annotation);
        if (annotation.inDeclaration)
            checkWithin(declaration, declaration.value, annotation.defaults, annotation);
    } else {
        chooseRange(annotation);
        if (value.text.starts_with('#') && !annotation.inDeclaration)
            annotation.high = 1.0; // of a colour
    }
}

Annotation annotationOf(const Declaration& declaration)
{
    const UniformType& type = *declaration.type;
    Annotation annotation;
    annotation.name = declaration.name.text;
    annotation.type = type.name;
    annotation.defaults.resize(static_cast<std::size_t>(type.components));
    annotation.where = declaration.name.at;
    if (const auto value = literalIn(declaration.value.text, type)) {
        annotation.defaults = *value;
        annotation.inDeclaration =
            ValueColumns{declaration.value.column, static_cast<int>(declaration.value.text.size())};
    }
    chooseRange(annotation);
    readComment(declaration, annotation);
    return annotation;
}

} // namespace

std::vector<Annotation> annotationsOf(const SourceText& source)
{
    const ShaderTokens tokens = tokensOf(source);
    std::vector<Annotation> annotations;
    for (std::size_t i = 0; i < tokens.all.size(); ++i)
        if (tokens.all[i].text == "uniform")
            if (const auto declaration = declarationAt(source, tokens.all, i))
                annotations.push_back(annotationOf(*declaration));
    return annotations;
}

} // namespace dioptre
