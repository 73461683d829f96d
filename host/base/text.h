// Small helpers on text that several layers need.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

// The candidate nearest to `word` by edit distance, or "" when none is near enough to be a slip of the pen.
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates);

// The pieces joined with `separator` between them.
std::string join(const std::vector<std::string>& pieces, std::string_view separator);

// The keys of a map by name, in its order.
template <typename Map>
std::vector<std::string> keysOf(const Map& map)
{
    std::vector<std::string> keys;
    for (const auto& [key, value] : map)
        keys.push_back(key);
    return keys;
}

// 64-bit FNV-1a of the bytes: the fingerprint under which shader texts and settings are compared.
unsigned long long fingerprint(std::string_view bytes);

// "2/8", "640x360": whole numbers from 1 to a million with `between` between them. False for anything else.
bool readPair(std::string_view text, char between, int& first, int& second);

} // namespace dioptre
