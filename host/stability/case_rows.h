// The stability suite's cases: what each is about, its rays, and what a kernel must reach on them.
#pragma once

#include "oracle/problem.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

class RandomFloats;

// The largest that each figure may be; what is not set is not asked for. That no result is NaN or infinite
// always is. The figures are defined at CaseFigures.
struct Gate {
    std::optional<double> k{};
    std::optional<double> relativeT{};
    std::optional<double> relativeT_p999{};
    std::optional<double> normal_rad{};
    std::optional<double> flips{};           // per million rays
    std::optional<double> flipsOverMargin{}; // per million rays
    std::optional<double> leaks{};           // per million groups
};

struct CaseRow {
    std::string_view name;
    std::string_view about; // one phrase
    bool control = false;   // passed by the textbook's kernel too
    Gate gate;
    // Appends one ray's problems: one, or `group` of them where neighbours share it, of which one is hit at
    // least.
    void (*append)(RandomFloats& random, std::vector<RayProblem>& problems) = nullptr;
    std::size_t group = 1;
    std::size_t rays = 200000; // of a full run
};

// In the order of the table.
std::span<const CaseRow> caseRows();

// Fails with ExitCode::usage on a name that is none.
const CaseRow& caseRow(std::string_view name);

// Topics of the table, in order.
std::span<const CaseRow> sphereCases();
std::span<const CaseRow> cylinderCases();
std::span<const CaseRow> flatCases();
std::span<const CaseRow> surfaceCases(); // shared edges, degenerate shapes, rays that leave a surface

// The first `count` problems of a case, up to whole groups: the same for the same seed, on every platform.
// All numbers are floats; directions are unit to float, save where the case is about their length.
std::vector<RayProblem> problemsOf(std::string_view caseName, std::uint64_t seed, std::size_t count);

// solve() of each, on all cores. Throws retry where an Interruption was noted.
std::vector<RayAnswer> answersOf(std::span<const RayProblem> problems);

// "K <= 8, no flips over margin".
std::string gateText(const Gate& gate);

} // namespace dioptre
