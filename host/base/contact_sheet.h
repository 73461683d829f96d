// Pictures side by side on one sheet, with what they are and how far they differ.
#pragma once

#include "base/canvas.h"

#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// One picture of a sheet. Texts are UTF-8, each on a line of its own.
struct SheetColumn {
    std::string title;                   // above the picture
    std::vector<std::string> lines;      // under it: "RMSE 0.0123"
    Picture picture;                     // of any format; floats are clamped to 0..1 and encoded by sRGB
    std::optional<Picture> difference{}; // from the reference; none where this is the reference
};

// What is said of the difference pictures.
struct DifferenceLabels {
    std::string caption = "difference"; // above each row of them: "difference, white = 0.25"
    std::vector<Colour8> scale{}; // from none to the largest, a bar beside the caption; none where empty
    std::string withoutOne = "reference"; // in the cell of a column that has none
};

// Pixels of width from which columns go on below, in rows of like length; a single column may be wider.
inline constexpr int widestSheet = 4000;

// The heading, then columns of one width: title, picture, lines, difference. Pictures keep their pixels, and
// the text's size follows the widest of them. A column is as wide as the widest picture or, where that is
// narrow, as its texts need, up to 22 times their size; longer ones end in an ellipsis. Gives an srgb8
// picture, without the rows of differences where no column has one. Throws as Lettering does.
Picture contactSheet(const std::string& heading, const std::vector<SheetColumn>& columns,
                     const DifferenceLabels& labels = {});

} // namespace dioptre
