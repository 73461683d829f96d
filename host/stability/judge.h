// A device's answers held against the oracle's.
#pragma once

#include "stability/case_rows.h"

#include <span>
#include <string>

namespace dioptre
{

// What a kernel said of one problem. Where it says miss, t and normal count for nothing but must be finite.
struct DeviceAnswer {
    bool hit = false;
    double t = 0.0;         // in lengths of the problem's direction
    glm::dvec3 normal{0.0}; // the surface's own, as RayAnswer says; of any length
};

// Largest figures over rays that both answers call a hit, unless said otherwise. Margins are RayAnswer's.
struct CaseFigures {
    std::size_t rays = 0;         // problems, those that share a ray each counted
    std::size_t judged = 0;       // hits of both
    std::size_t judgedOver8 = 0;  // of these with a margin over 8
    std::size_t judgedOver64 = 0; // and over 64
    double k = 0.0;               // |t - t*| |d| cos i / (2^-24 extent), margin over 8; t* the oracle's
    double relativeT = 0.0;       // |t - t*| / t*, margin over 64
    double relativeT_p999 = 0.0;  // its quantile 0.999 over all
    double normal_rad = 0.0;      // angle of the normals, margin over 64
    double flips = 0.0;           // per million problems: one answer hits, the other does not
    double flipsOverMargin = 0.0; // the same with a margin over 8, per million of all problems
    double leaks = 0.0;        // per million groups: the device hits no member of it, the oracle one at least
    std::size_t nonFinite = 0; // answers with a NaN or an infinity, hits or not
};

// All spans are equally long, group after whole group of the row.
CaseFigures measureCase(const CaseRow& row, std::span<const RayProblem> problems,
                        std::span<const RayAnswer> truth, std::span<const DeviceAnswer> answers);

struct Verdict {
    bool pass = false;
    std::string reason; // every breach in words, "" if it passes
};

// Against the row's gate. A figure that no ray stands behind is a breach too.
Verdict judgeCase(const CaseRow& row, const CaseFigures& figures);

} // namespace dioptre
