// Where two pictures differ, as a picture.
#pragma once

#include "base/picture_writer.h"
#include "command/compare.h"
#include "metric/pair.h"

#include <vector>

namespace dioptre
{

// Throws usage where the output is of a kind that is not written, or is one of the pictures compared.
void refuseBadDifference(const CompareOptions& options);

// A file under a temporary name, so that faults show before long work; `hdr` says which FLIP it is to show.
// Throws cannotWrite.
std::unique_ptr<PictureWriter> openDifference(const CompareOptions& options, int width, int height, bool hdr);

// Ends the file. PNG: `errors` of FLIP in magma, and green where a pixel is not judged. HDR and EXR: |picture
// - reference| of each channel of a linear pair, and NaN where a pixel is not judged, which HDR holds as 0.
void writeDifference(PictureWriter& file, const CompareOptions& options, const PicturePair& pair,
                     const std::vector<float>& errors);

} // namespace dioptre
