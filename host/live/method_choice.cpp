#include "live/method_choice.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{

MethodChoice methodChoice(const LiveOptions& options)
{
    MethodChoice choice;
    choice.method = methodNamed(options.method);
    if (isRasterised(choice.method))
        choice.other = {};
    if (!options.compare.empty()) {
        choice.other = methodNamed(options.compare);
        choice.comparison = Comparison::split;
    }
    return choice;
}

void refuseBadMethods(const LiveOptions& options, const LiveInput& input)
{
    const MethodChoice choice = methodChoice(options);
    const bool asked = choice.method != Method{} || choice.comparison != Comparison::off;
    if (asked && input.plainShader)
        fail(ExitCode::usage,
             options.input + " is " + (input.picture.empty() ? "a plain shader" : "a picture") +
                 ", and --method and --compare are for scenes",
             "leave them out");
    if (asked && !options.view.empty())
        fail(ExitCode::usage,
             "--view " + options.view +
                 " is of a traced picture alone, and --method or --compare asks for more",
             "leave one of them out");
}

std::vector<Method> drawnMethods(const MethodChoice& choice)
{
    std::vector<Method> methods{choice.method};
    if (choice.comparison != Comparison::off && choice.other != choice.method)
        methods.push_back(choice.other);
    return methods;
}

bool drawsFacets(const MethodChoice& choice)
{
    return std::ranges::any_of(drawnMethods(choice), isRasterised);
}

std::string_view nameOf(Comparison comparison)
{
    return std::ranges::find(comparisons, comparison, &ComparisonRow::comparison)->name;
}

MethodChoice nextComparison(MethodChoice choice)
{
    choice.comparison = choice.comparison == Comparison::split        ? Comparison::difference
                        : choice.comparison == Comparison::difference ? Comparison::off
                                                                      : Comparison::split;
    return choice;
}

MethodChoice flipped(MethodChoice choice)
{
    choice.comparison = choice.comparison == Comparison::second ? Comparison::first : Comparison::second;
    return choice;
}

MethodChoice nextScale(MethodChoice choice)
{
    const auto now = std::ranges::find(differenceScales, choice.scale);
    choice.scale = now == differenceScales.end() || now + 1 == differenceScales.end()
                       ? differenceScales.front()
                       : *(now + 1);
    return choice;
}

std::string nameOf(const MethodChoice& choice)
{
    const std::string first = nameOf(choice.method), second = nameOf(choice.other);
    switch (choice.comparison) {
    case Comparison::split:
        return first + " | " + second;
    case Comparison::difference:
        return fmt::format("|{} - {}| x {}", first, second, choice.scale);
    default:
        return nameOf(methodInFull(choice));
    }
}

Method methodInFull(const MethodChoice& choice)
{
    return choice.comparison == Comparison::second ? choice.other : choice.method;
}

} // namespace dioptre
