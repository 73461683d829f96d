#include "command/figures.h"

#include <nlohmann/json.hpp>

namespace dioptre
{

std::optional<std::vector<double>> numbersIn(const std::string& text, const std::vector<std::string>& keys)
{
    const auto json = nlohmann::json::parse(text, nullptr, false);
    std::vector<double> numbers;
    for (const auto& key : keys) {
        if (!json.is_object() || !json.contains(key) || !json[key].is_number())
            return std::nullopt;
        numbers.push_back(json[key].get<double>());
    }
    return numbers;
}

} // namespace dioptre
