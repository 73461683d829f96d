// Errors of radiance as it stands: unclamped and linear.
#pragma once

#include "metric/pair.h"

namespace dioptre
{

// With r a number of the reference and x that of the picture, means run over R, G and B of all judged pixels;
// all are NaN where there is none.
struct LinearError {
    double rmse = 0.0;   // sqrt(mean((x - r)^2)), radiance
    double mae = 0.0;    // mean(|x - r|), radiance
    double relmse = 0.0; // mean((x - r)^2 / (|r| + 0.01)^2); |r| for what is negative by mistake
    double max = 0.0;    // the largest |x - r|, radiance
    int maxX_px = 0;     // where that is: columns from the left,
    int maxY_px = 0;     // rows from the top; of several the first in the order of reading
};

// Takes a linear pair.
LinearError linearError(const PicturePair& pair);

} // namespace dioptre
