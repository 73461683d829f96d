// One TOML value read as what the scene wants, or refused where it stands. `name` is what messages call it.
#pragma once

#include "scene/document.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

// The numbers that a key allows. Finite in every case: NaN and infinity would spread over the whole picture.
struct Range {
    double low;
    double high;
    bool open;               // the ends themselves are not allowed
    std::string_view wanted; // in words: "a number above 0"
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr Range anyNumber{-unbounded, unbounded, false, "a finite number"};
inline constexpr Range aboveZero{0.0, unbounded, true, "a number above 0"};
inline constexpr Range zeroOrMore{0.0, unbounded, false, "a number of at least 0"};
inline constexpr Range zeroToOne{0.0, 1.0, false, "a number from 0 to 1"};
inline constexpr Range roughness{1e-4, 1.0, false, "a number from 0.0001 to 1"};

// Throws badInput "NAME is VALUE: give WANTED".
[[noreturn]] void refuse(const Value& value, std::string_view name, std::string_view wanted);

// Refuses a word that is not among `known`, with the nearest of them or, failing that, all of them.
[[noreturn]] void refuseWord(const SourcePosition& where, std::string_view what, std::string_view word,
                             const std::vector<std::string>& known);

const std::string& textFrom(const Value& value, std::string_view name, std::string_view wanted = "a string");
bool flagFrom(const Value& value, std::string_view name);
int integerFrom(const Value& value, std::string_view name, int low, int high);
double numberFrom(const Value& value, std::string_view name, const Range& range);
const Array& arrayFrom(const Value& value, std::string_view name, std::string_view wanted);
const Array& arrayFrom(const Value& value, std::string_view name, std::size_t count, std::string_view wanted);

// Three numbers, all in the range.
glm::dvec3 vectorFrom(const Value& value, std::string_view name, const Range& range);

// A direction or an edge: as vectorFrom, and not all zero.
glm::dvec3 nonZeroFrom(const Value& value, std::string_view name);

// "#rrggbb", sRGB, as linear light; nothing for any other text.
std::optional<glm::dvec3> hexColour(const std::string& text);

// Linear: three numbers of at least 0, or "#rrggbb" decoded from sRGB.
glm::dvec3 colourFrom(const Value& value, std::string_view name);

// As many colours as `count` says.
std::vector<glm::dvec3> coloursFrom(const Value& value, std::string_view name, std::size_t count);

} // namespace dioptre
