// JSON for standard output and files.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace dioptre
{

// Indented, with a line end. Bytes that are no UTF-8, which file names may hold, become U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json)
{
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace dioptre
