#include "base/utf8.h"

#include <array>

namespace dioptre
{
namespace
{

constexpr char32_t replacementCharacter = 0xFFFD;

// Bytes that follow `lead` in its code point; -1 where no code point begins so.
int followersOf(unsigned char lead)
{
    if (lead < 0x80)
        return 0;
    if (lead < 0xC0 || lead > 0xF7)
        return -1;
    return lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
}

} // namespace

char32_t nextCodePoint(std::string_view text, std::size_t& at)
{
    const auto lead = static_cast<unsigned char>(text[at++]);
    const int followers = followersOf(lead);
    if (followers <= 0)
        return followers == 0 ? lead : replacementCharacter;
    const auto count = static_cast<std::size_t>(followers);
    if (text.size() - at < count)
        return replacementCharacter;
    char32_t code = lead & (0x3FU >> count);
    for (const char follower : text.substr(at, count)) {
        const auto byte = static_cast<unsigned char>(follower);
        if ((byte & 0xC0U) != 0x80U)
            return replacementCharacter;
        code = (code << 6) | (byte & 0x3FU);
    }
    // Longer than need be, half of a UTF-16 pair, or beyond Unicode.
    constexpr std::array<char32_t, 4> smallest = {0, 0x80, 0x800, 0x10000};
    if (code < smallest[count] || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF)
        return replacementCharacter;
    at += count;
    return code;
}

} // namespace dioptre
