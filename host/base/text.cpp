#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>

namespace dioptre
{
namespace
{

std::string lowerCase(std::string_view word)
{
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return lower;
}

// Insertions, deletions, replacements and swaps of neighbours (optimal string alignment; three rows suffice).
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        beforeLast.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row[b.size()];
}

} // namespace

// Near enough means one slip for every three letters of the longer word; case does not count.
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates)
{
    const std::string wanted = lowerCase(word);
    std::string nearest;
    std::size_t nearestDistance = 0;
    for (const std::string& candidate : candidates) {
        const auto [shorter, longer] = std::minmax({wanted.size(), candidate.size()});
        if (longer - shorter > longer / 3) // far from near: so many letters are missing
            continue;
        const std::size_t distance = editDistance(wanted, lowerCase(candidate));
        if (distance <= longer / 3 && (nearest.empty() || distance < nearestDistance)) {
            nearest = candidate;
            nearestDistance = distance;
        }
    }
    return nearest;
}

std::string join(const std::vector<std::string>& pieces, std::string_view separator)
{
    std::string joined;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i > 0)
            joined += separator;
        joined += pieces[i];
    }
    return joined;
}

// Fowler, Noll and Vo, http://www.isthe.com/chongo/tech/comp/fnv/
unsigned long long fingerprint(std::string_view bytes)
{
    unsigned long long hash = 0xcbf29ce484222325ull;
    for (const char byte : bytes) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 0x100000001b3ull;
    }
    return hash;
}

bool readPair(std::string_view text, char between, int& first, int& second)
{
    constexpr int most = 1'000'000; // products of two fit
    const char* end = text.data() + text.size();
    const auto [middle, fault] = std::from_chars(text.data(), end, first);
    if (fault != std::errc() || middle == end || *middle != between)
        return false;
    const auto [last, secondFault] = std::from_chars(middle + 1, end, second);
    return secondFault == std::errc() && last == end && std::min(first, second) >= 1 &&
           std::max(first, second) <= most;
}

} // namespace dioptre
