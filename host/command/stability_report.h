// The table of `dioptre stability`, for people, as CSV and as JSON.
#pragma once

#include "command/stability.h"
#include "gl/context.h"
#include "stability/judge.h"
#include "stability/value_run.h"

#include <vector>

namespace dioptre
{

struct StabilityResult {
    const CaseRow* row = nullptr;
    CaseFigures figures; // of our kernels, the strictest for each problem
    Verdict verdict;
    CaseFigures textbook;
    Verdict textbookVerdict; // of the same gate
};

struct StabilityTable {
    std::vector<StabilityResult> cases; // intersections
    std::vector<ValueOutcome> values;   // optics and paths
    std::size_t failures() const;
};

// A row of the table on standard output, under a heading where it is the first of its kind.
void printRow(const StabilityResult& result, bool first);
void printRow(const ValueOutcome& result, bool first);

// What follows the table, the CSV file and the JSON, as the options ask. Throws cannotWrite.
void report(const StabilityOptions& options, const ContextInfo& device, const StabilityTable& table);

} // namespace dioptre
