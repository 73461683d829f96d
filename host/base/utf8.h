// Text of UTF-8 taken apart.
#pragma once

#include <cstddef>
#include <string_view>

namespace dioptre
{

// The code point that begins at byte `at`, which is then moved behind it; `at` below text.size(). A byte that
// belongs to none, as file names may hold, gives U+FFFD.
char32_t nextCodePoint(std::string_view text, std::size_t& at);

} // namespace dioptre
