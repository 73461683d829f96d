// A user's own rays and shapes, and what they hit, as CSV.
#pragma once

#include "stability/judge.h"

#include <span>
#include <string>
#include <vector>

namespace dioptre
{

// Reads the columns case, id, prim, p0 to p8, ox, oy, oz, dx, dy, dz, tmin and spawn, in any order, found by
// the names in the first line; others are left alone. `path` is what faults name. Throws badInput: a column
// that is missing, a line of another length, what is no number, a kind that is none.
std::vector<RayProblem> readBatch(const std::string& text, const std::string& path);

// case,id,hit,t,px,py,pz,nx,ny,nz with nine significant digits; t in lengths of the given direction, normals
// unit and the surface's own. What is missed has zeros.
std::string batchText(std::span<const RayProblem> problems, std::span<const DeviceAnswer> answers);

} // namespace dioptre
