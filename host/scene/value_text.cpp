#include "scene/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace dioptre
{
namespace
{

constexpr std::int64_t mostExact = std::int64_t{1} << 53; // beyond it doubles leave out whole numbers

std::string quotedText(std::string_view text)
{
    std::string result = "\"";
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\')
            (result += '\\') += letter;
        else if (byte < 0x20 || byte == 0x7F)
            result += fmt::format("\\u{:04X}", byte);
        else
            result += letter;
    }
    return result + '"';
}

std::string floatText(double number)
{
    std::string text = fmt::format("{}", number);
    if (text.find_first_not_of("-0123456789") == std::string::npos) // neither a point nor e, inf or nan
        text += ".0";
    return text;
}

// What the text is written by: the value, and what it takes the place of.
struct Writer {
    const Value* old;

    std::string operator()(const std::string& text) const
    {
        return quotedText(text);
    }
    std::string operator()(std::int64_t number) const
    {
        const bool wasFloat = old && std::holds_alternative<double>(old->data);
        return wasFloat && std::abs(number) <= mostExact ? floatText(static_cast<double>(number))
                                                         : std::to_string(number);
    }
    std::string operator()(double number) const
    {
        return floatText(number);
    }
    std::string operator()(bool flag) const
    {
        return flag ? "true" : "false";
    }
    std::string operator()(const Moment&) const
    {
        fail(ExitCode::badInput, "a date cannot be written into a scene",
             "give a number, a string or a list");
    }
    // Of a list in another's place the numbers go by the other's first.
    std::string operator()(const Array& array) const
    {
        const auto* others = old ? std::get_if<Array>(&old->data) : nullptr;
        std::string text = "[";
        for (std::size_t i = 0; i < array.size(); ++i) {
            const Value* other = !others || others->empty() ? nullptr : &(*others)[i % others->size()];
            text += (i == 0 ? "" : ", ") + valueText(array[i], other);
        }
        return text + "]";
    }
    std::string operator()(const Table&) const
    {
        fail(ExitCode::badInput, "a table cannot be written as a value", "set its keys one by one");
    }
};

bool saySame(const Table& a, const Table& b)
{
    return a.entries.size() == b.entries.size() && std::ranges::all_of(a.entries, [&b](const Entry& entry) {
               const Value* other = find(b, entry.key);
               return other != nullptr && saySame(entry.value, *other);
           });
}

bool saySame(std::int64_t whole, double number)
{
    return std::abs(whole) <= mostExact && static_cast<double>(whole) == number;
}

struct Comparison {
    template <typename Kind>
    bool operator()(const Kind& a, const Kind& b) const
    {
        return a == b;
    }
    bool operator()(double a, double b) const
    {
        return (a == b && std::signbit(a) == std::signbit(b)) || (std::isnan(a) && std::isnan(b));
    }
    bool operator()(const Moment&, const Moment&) const
    {
        return true;
    }
    bool operator()(const Array& a, const Array& b) const
    {
        return std::ranges::equal(a, b, [](const Value& x, const Value& y) { return saySame(x, y); });
    }
    bool operator()(const Table& a, const Table& b) const
    {
        return saySame(a, b);
    }
    bool operator()(std::int64_t a, double b) const
    {
        return saySame(a, b);
    }
    bool operator()(double a, std::int64_t b) const
    {
        return saySame(b, a);
    }
    template <typename One, typename Other>
    bool operator()(const One&, const Other&) const
    {
        return false;
    }
};

} // namespace

std::string keyText(std::string_view key)
{
    const bool bare = !key.empty() && std::ranges::all_of(key, [](unsigned char letter) {
        return (letter < 0x80 && std::isalnum(letter) != 0) || letter == '_' || letter == '-';
    });
    return bare ? std::string(key) : quotedText(key);
}

std::string valueText(const Value& value, const Value* old)
{
    return std::visit(Writer{old}, value.data);
}

bool saySame(const Value& a, const Value& b)
{
    return std::visit(Comparison{}, a.data, b.data);
}

} // namespace dioptre
