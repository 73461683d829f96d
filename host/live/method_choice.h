// Which methods a window shows of a scene, and how two of them are held against each other.
#pragma once

#include "command/command.h"
#include "live/live_input.h"
#include "raster/method.h"

#include <array>
#include <string_view>
#include <vector>

namespace dioptre
{

enum class Comparison { off, split, difference, first, second };

struct ComparisonRow {
    std::string_view name;
    Comparison comparison;
    std::string_view meaning; // a phrase for people
};

inline constexpr std::array comparisons{
    ComparisonRow{"off", Comparison::off, "one method alone"},
    ComparisonRow{"split", Comparison::split, "one left of a divider, the other right of it"},
    ComparisonRow{"difference", Comparison::difference, "how far their radiances are from each other"},
    ComparisonRow{"first", Comparison::first, "the left one in full"},
    ComparisonRow{"second", Comparison::second, "the right one in full"},
};

// What a difference can be shown times.
inline constexpr std::array differenceScales{1, 2, 4, 8, 16, 32, 64};

struct MethodChoice {
    Method method; // what is shown; of two the left one
    Method other{Shading::phong, usualFacets};
    Comparison comparison = Comparison::off;
    double divider = 0.5; // of the picture's width, that is left of it
    int scale = 1;        // of a difference
    bool wires = false;   // facets' edges over a rasterised picture
};

// Throws usage for words that name no method.
MethodChoice methodChoice(const LiveOptions& options);

// Throws usage where the input has no methods or a view asks for rays.
void refuseBadMethods(const LiveOptions& options, const LiveInput& input);

// Each once, the one that is shown first.
std::vector<Method> drawnMethods(const MethodChoice& choice);

// Whether facets are drawn.
bool drawsFacets(const MethodChoice& choice);

std::string_view nameOf(Comparison comparison);

// Split, difference, off; and between the two in full.
MethodChoice nextComparison(MethodChoice choice);
MethodChoice flipped(MethodChoice choice);
MethodChoice nextScale(MethodChoice choice);

// What is seen in a word: "trace", "trace | phong:64", "|trace - phong:64| x 8".
std::string nameOf(const MethodChoice& choice);

// The one that a picture of a single method is of.
Method methodInFull(const MethodChoice& choice);

} // namespace dioptre
