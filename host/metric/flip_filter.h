// The filters of FLIP (Andersson et al. 2020): how sharply the eye sees, and what it takes for edges and
// points.
#pragma once

#include "metric/plane.h"

#include <vector>

namespace dioptre
{

// A Gaussian, or a sum of two, which together weigh 1.
struct ContrastFilter {
    struct Term {
        Kernel kernel;      // along rows and along columns; weighs 1
        double share = 0.0; // of the whole
    };
    std::vector<Term> terms;
};

// All of one distance: so many pixels a degree of the viewer's field.
struct FlipFilters {
    ContrastFilter achromatic; // of Yy
    ContrastFilter redGreen;   // of Cx
    ContrastFilter blueYellow; // of Cz

    // A feature along a row is the slope along rows of what is smooth along columns, and so on.
    Kernel smooth;
    Kernel slope;     // an edge: first derivative of a Gaussian
    Kernel curvature; // a point: second derivative

    std::size_t reach = 0; // the largest radius of all, pixels
};

// pixelsPerDegree: 1 or more.
FlipFilters flipFilters(double pixelsPerDegree);

// The filter applied to the rows first to first + rows - 1 of a plane.
Plane filtered(const Plane& plane, const ContrastFilter& filter, std::size_t first, std::size_t rows);

} // namespace dioptre
