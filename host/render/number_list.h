// Numbers as people write them for a uniform.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace dioptre
{

// "0.5", "true", "[1, 2, 3]", "1,2,3", "#ff8000" (linear shares of 255, as a shader takes them). Nothing
// where the text is something else.
std::optional<std::vector<double>> numbersIn(std::string_view text);

} // namespace dioptre
