// Problems as the rows of glsl/stability/shapes.frag.
#pragma once

#include "oracle/problem.h"
#include "render/table_run.h"
#include "stability/variant.h"

#include <span>

namespace dioptre
{

// Where the numbers are seen from before they become floats.
enum class Frame {
    given, // as they stand: what a scene's shader meets once its origin has been chosen
    ofRay  // the ray's origin, in double precision, with lengths scaled by powers of two
};

struct KernelRows {
    DeviceTable table;
    std::vector<double> lengthOfT; // by row: what a row's t is to be multiplied with
};

// All problems of one kind of shape.
KernelRows kernelRows(std::span<const RayProblem> problems, Variant variant, Frame frame);

} // namespace dioptre
