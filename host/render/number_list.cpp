#include "render/number_list.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace dioptre
{
namespace
{

std::optional<std::vector<double>> colourIn(std::string_view text)
{
    std::vector<double> colour;
    for (std::size_t i = 1; i < 7; i += 2) {
        int byte = 0;
        const auto [end, fault] = std::from_chars(&text[i], &text[i] + 2, byte, 16);
        if (fault != std::errc() || end != &text[i] + 2)
            return std::nullopt;
        colour.push_back(byte / 255.0);
    }
    return colour;
}

} // namespace

std::optional<std::vector<double>> numbersIn(std::string_view text)
{
    if (text.starts_with('#') && text.size() == 7)
        return colourIn(text);
    if (text.starts_with('[') && text.ends_with(']'))
        text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto comma = std::min(text.find(',', begin), text.size());
        std::string word(text.substr(begin, comma - begin));
        std::erase(word, ' ');
        begin = comma + 1;
        double number = word == "true" ? 1.0 : 0.0;
        if (word != "true" && word != "false") {
            const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
            if (word.empty() || fault != std::errc() || end != word.data() + word.size())
                return std::nullopt;
        }
        numbers.push_back(number);
    }
    return numbers;
}

} // namespace dioptre
