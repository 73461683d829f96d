// Figures that another process of ours printed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// The numbers under `keys` of a JSON object; nothing where the text is none or lacks one of them.
std::optional<std::vector<double>> numbersIn(const std::string& json, const std::vector<std::string>& keys);

} // namespace dioptre
