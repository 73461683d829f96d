// The two pictures of `dioptre compare`.
#pragma once

#include "command/compare.h"
#include "metric/pair.h"

namespace dioptre
{

struct ComparedPictures {
    PicturePair pair;               // linear
    bool displayedReference = true; // PNG or JPEG: what a display was sent; otherwise radiance
    bool displayedPicture = true;
};

// Throws inputMissing, badInput; usage for numbers out of reach, and for an --exposure or --curve that no
// picture heeds.
ComparedPictures readCompared(const CompareOptions& options);

} // namespace dioptre
