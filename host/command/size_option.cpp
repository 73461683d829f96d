#include "command/size_option.h"

#include "base/error.h"

#include <fmt/format.h>

#include <cstdio>

namespace dioptre
{
namespace
{

constexpr int largestSide_px = 16384; // what every OpenGL driver that we know draws at once

} // namespace

void readSize(const std::string& text, int& width, int& height)
{
    int used = 0;
    const int found = std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used);
    const auto sane = [](int side) { return side >= 1 && side <= largestSide_px; };
    if (found != 2 || static_cast<std::size_t>(used) != text.size() || !sane(width) || !sane(height))
        fail(ExitCode::usage, fmt::format("--size {} is not a size", text),
             fmt::format("write WIDTHxHEIGHT in pixels, each 1 to {}, as in --size 640x360", largestSide_px));
}

} // namespace dioptre
