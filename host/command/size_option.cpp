#include "command/size_option.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace dioptre
{
namespace
{

constexpr int largestSide_px = 131072; // the places of samples are floats: 1/64 of a pixel there

// A whole number of decimal digits, 0 where the text is anything else or too large.
int sideIn(std::string_view text)
{
    int side = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), side);
    const bool whole = fault == std::errc() && end == text.data() + text.size();
    return whole && side >= 1 && side <= largestSide_px ? side : 0;
}

} // namespace

void readSize(const std::string& text, int& width, int& height)
{
    const auto cross = std::min(text.find('x'), text.size());
    width = sideIn(std::string_view(text).substr(0, cross));
    height = cross < text.size() ? sideIn(std::string_view(text).substr(cross + 1)) : 0;
    if (width == 0 || height == 0)
        fail(ExitCode::usage, fmt::format("--size {} is not a size", text),
             fmt::format("write WIDTHxHEIGHT in pixels, each 1 to {}, as in --size 640x360", largestSide_px));
}

} // namespace dioptre
