#include "scene/value_reader.h"

#include "base/picture.h"
#include "base/text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace dioptre
{

namespace
{

std::string elementName(std::string_view name, std::size_t index)
{
    return fmt::format("{}[{}]", name, index);
}

} // namespace

std::optional<glm::dvec3> hexColour(const std::string& text)
{
    if (text.size() != 7 || text[0] != '#')
        return std::nullopt;
    glm::dvec3 colour;
    for (int channel = 0; channel < 3; ++channel) {
        const char* first = text.data() + 1 + 2 * channel;
        unsigned byte = 0;
        if (std::from_chars(first, first + 2, byte, 16).ptr != first + 2)
            return std::nullopt;
        colour[channel] = static_cast<double>(linearFromSrgb8(static_cast<std::uint8_t>(byte)));
    }
    return colour;
}

void refuse(const Value& value, std::string_view name, std::string_view wanted)
{
    fail(ExitCode::badInput, value.where, fmt::format("{} is {}", name, inWords(value)),
         fmt::format("give {}", wanted));
}

void refuseWord(const SourcePosition& where, std::string_view what, std::string_view word,
                const std::vector<std::string>& known)
{
    const std::string nearest = nearestWord(word, known);
    if (!nearest.empty())
        fail(ExitCode::badInput, where, what, fmt::format("did you mean '{}'?", nearest));
    if (known.empty())
        fail(ExitCode::badInput, where, what, "there is none to choose from");
    fail(ExitCode::badInput, where, what, fmt::format("choose from {}", join(known, ", ")));
}

const std::string& textFrom(const Value& value, std::string_view name, std::string_view wanted)
{
    const auto* text = std::get_if<std::string>(&value.data);
    if (!text)
        refuse(value, name, wanted);
    return *text;
}

bool flagFrom(const Value& value, std::string_view name)
{
    const auto* flag = std::get_if<bool>(&value.data);
    if (!flag)
        refuse(value, name, "true or false");
    return *flag;
}

int integerFrom(const Value& value, std::string_view name, int low, int high)
{
    const auto* number = std::get_if<std::int64_t>(&value.data);
    if (number && *number >= low && *number <= high)
        return static_cast<int>(*number);
    if (high == std::numeric_limits<int>::max())
        refuse(value, name, fmt::format("a whole number of at least {}", low));
    refuse(value, name, fmt::format("a whole number from {} to {}", low, high));
}

double numberFrom(const Value& value, std::string_view name, const Range& range)
{
    double number = 0.0;
    if (const auto* real = std::get_if<double>(&value.data))
        number = *real;
    else if (const auto* integer = std::get_if<std::int64_t>(&value.data))
        number = static_cast<double>(*integer);
    else
        refuse(value, name, range.wanted);
    if (!std::isfinite(number))
        refuse(value, name, anyNumber.wanted);
    if (std::abs(number) > static_cast<double>(std::numeric_limits<float>::max()))
        refuse(value, name, "a number that a 32-bit float can hold");
    const bool inside =
        range.open ? number > range.low && number < range.high : number >= range.low && number <= range.high;
    if (!inside)
        refuse(value, name, range.wanted);
    return number;
}

const Array& arrayFrom(const Value& value, std::string_view name, std::string_view wanted)
{
    const auto* array = std::get_if<Array>(&value.data);
    if (!array)
        refuse(value, name, wanted);
    return *array;
}

const Array& arrayFrom(const Value& value, std::string_view name, std::size_t count, std::string_view wanted)
{
    const Array& array = arrayFrom(value, name, wanted);
    if (array.size() != count)
        refuse(value, name, wanted);
    return array;
}

glm::dvec3 vectorFrom(const Value& value, std::string_view name, const Range& range)
{
    const Array& array = arrayFrom(value, name, 3, "three numbers, [x, y, z]");
    glm::dvec3 vector;
    for (int i = 0; i < 3; ++i) {
        const auto index = static_cast<std::size_t>(i);
        vector[i] = numberFrom(array[index], elementName(name, index), range);
    }
    return vector;
}

glm::dvec3 nonZeroFrom(const Value& value, std::string_view name)
{
    const glm::dvec3 vector = vectorFrom(value, name, anyNumber);
    if (vector == glm::dvec3(0.0))
        fail(ExitCode::badInput, value.where, fmt::format("{} is zero and points nowhere", name),
             "give a vector with a length");
    return vector;
}

glm::dvec3 colourFrom(const Value& value, std::string_view name)
{
    constexpr std::string_view wanted = "a colour: [r, g, b], linear, or \"#rrggbb\", sRGB";
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        const std::optional<glm::dvec3> colour = hexColour(*text);
        if (!colour)
            refuse(value, name, wanted);
        return *colour;
    }
    arrayFrom(value, name, 3, wanted);
    return vectorFrom(value, name, zeroOrMore);
}

std::vector<glm::dvec3> coloursFrom(const Value& value, std::string_view name, std::size_t count)
{
    const Array& array = arrayFrom(value, name, count, fmt::format("an array of {} colours", count));
    std::vector<glm::dvec3> colours;
    for (std::size_t i = 0; i < count; ++i)
        colours.push_back(colourFrom(array[i], elementName(name, i)));
    return colours;
}

} // namespace dioptre
