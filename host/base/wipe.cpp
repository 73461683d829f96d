#include "base/wipe.h"

#include "base/error.h"
#include "base/lettering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

constexpr Colour8 black = {0, 0, 0};
constexpr Colour8 light = {240, 240, 240};
constexpr float plateShare = 0.6f; // of black behind a title
constexpr float edgeShare = 0.5f;  // of black beside the line

void checkSameSize(const Picture& left, const Picture& right)
{
    if (left.width != right.width || left.height != right.height)
        fail(ExitCode::badInput,
             fmt::format("pictures of {}x{} and {}x{} have no line between them", left.width, left.height,
                         right.width, right.height),
             "give two of one size");
}

void takeColumnsFrom(Picture& wipe, const Picture& right, int divider)
{
    Picture other = blankCanvas(right.width, right.height, black);
    paste(other, right, 0, 0);
    const auto width = static_cast<std::size_t>(right.width), first = static_cast<std::size_t>(divider);
    for (std::size_t row = 0; row < static_cast<std::size_t>(right.height); ++row) {
        const std::size_t begin = 4 * (row * width + first);
        std::copy_n(other.bytes.data() + begin, 4 * (width - first), wipe.bytes.data() + begin);
    }
}

// No line where all columns are of one picture.
void drawDivider(Picture& wipe, int divider)
{
    if (divider == 0 || divider == wipe.width)
        return;
    const int thickness = wipe.width < 1000 ? 1 : 2;
    blendRectangle(wipe, {divider - 1, 0, thickness + 2, wipe.height}, black, edgeShare);
    blendRectangle(wipe, {divider, 0, thickness, wipe.height}, light);
}

enum class Corner { left, right };

// In an upper corner of the columns from `begin` to `end` - 1.
void drawTitle(Picture& wipe, const Lettering& lettering, const std::string& title, int begin, int end,
               Corner corner)
{
    const int inset = lettering.descent();
    const std::string text = lettering.shortened(title, end - begin - 4 * inset);
    if (text.empty())
        return;
    const int width = lettering.width(text) + 2 * inset, height = lettering.lineHeight() + inset;
    const int x = corner == Corner::left ? begin + inset : end - inset - width,
              y = wipe.height - inset - height;
    blendRectangle(wipe, {x, y, width, height}, black, plateShare);
    lettering.draw(wipe, text, x + inset, y + inset / 2 + lettering.descent(), light);
}

} // namespace

Picture wiped(const Picture& left, const Picture& right, double share, const std::string& leftTitle,
              const std::string& rightTitle)
{
    checkSameSize(left, right);
    Picture wipe = blankCanvas(left.width, left.height, black);
    paste(wipe, left, 0, 0);
    const double within = share > 0.0 ? std::min(share, 1.0) : 0.0; // NaN is 0
    const int divider = static_cast<int>(std::lround(within * left.width));
    takeColumnsFrom(wipe, right, divider);
    drawDivider(wipe, divider);
    const Lettering lettering(legibleSize(left.width * 2 / 3)); // two titles share the width
    drawTitle(wipe, lettering, leftTitle, 0, divider, Corner::left);
    drawTitle(wipe, lettering, rightTitle, divider, wipe.width, Corner::right);
    return wipe;
}

} // namespace dioptre
