// Lines that are for a preprocessor.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dioptre
{

// "include" and "\"a.glsl\"" of `  #include "a.glsl"`.
struct Directive {
    std::string_view name;
    std::string_view argument;
};

// Nothing where the line is no directive; comments around it are not looked at.
std::optional<Directive> directiveOf(std::string_view line);

// What an #include's argument names; nothing where it is not in quotes.
std::optional<std::string> includedName(const Directive& include);

} // namespace dioptre
