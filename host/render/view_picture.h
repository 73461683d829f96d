// From the sums that a view draws to its data, to a picture that the eye can read, and to the legend of that
// picture.
#pragma once

#include "base/picture.h"
#include "render/prepare.h"

#include <string>
#include <utility>
#include <vector>

namespace dioptre
{

// What the colours of a view mean.
struct ViewLegend {
    struct Entry {
        std::string colour; // "#rrggbb", as the PNG holds it
        std::size_t id = 0;
        std::string name; // "" where unset
        std::string kind; // "sphere"
    };
    std::vector<std::string> lines;                      // for people
    std::vector<std::pair<std::string, double>> figures; // for scripts
    std::vector<Entry> objects;                          // of the object view
};

struct ShownView {
    Picture picture; // 0..1, unencoded
    ViewLegend legend;
};

// Sums over samples to sums of the view's data in rgb: rays from alpha, depth from what was met alone.
void dataFromSums(Picture& sums, DataView view, int samples);

// `data`: a sample's mean of a view other than none.
ShownView shownView(const Picture& data, const PreparedScene& prepared);

} // namespace dioptre
