// What `dioptre compare` finds, and how it is said.
#pragma once

#include "command/compare.h"
#include "metric/hdr_flip.h"
#include "metric/linear_error.h"

namespace dioptre
{

struct CompareResult {
    int width = 0;  // pixels
    int height = 0; // pixels
    LinearError linear;
    Display display;                        // of the pictures that hold radiance
    double psnr_db = 0.0;                   // infinite where equal; NaN where no pixel is judged
    double ssim = 0.0;                      // NaN where there is no window
    PooledFlip flip;                        // NaN where no pixel is judged
    std::optional<ExposureRange> exposures; // of HDR-FLIP; none of LDR-FLIP
    std::size_t nonfiniteReference = 0;     // pixels
    std::size_t nonfinitePicture = 0;       // pixels
    double total_ms = 0.0;                  // from the start of reading to the end of writing
};

std::string compareText(const CompareOptions& options, const CompareResult& result);
std::string compareJson(const CompareOptions& options, const CompareResult& result);

} // namespace dioptre
