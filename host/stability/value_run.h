// The rows beside intersections at work on the current context's device, and their verdicts.
#pragma once

#include "stability/kernel_run.h"
#include "stability/value_rows.h"

namespace dioptre
{

struct ValueFigure {
    double value = 0.0;     // as its gate says
    std::size_t judged = 0; // inputs that it rests on
};

struct ValueFigures {
    std::size_t rows = 0;             // inputs
    std::size_t nonFinite = 0;        // answers with a NaN or an infinity
    std::vector<ValueFigure> figures; // one for each of the row's gates
};

struct ValueOutcome {
    const ValueRow* row = nullptr;
    ValueFigures ours;
    Verdict verdict;
    ValueFigures textbook;
    Verdict textbookVerdict; // of the same gates
};

// `texels` of whole inputs as inputsOf() gives them, `answers` of row.parts a row; on all cores.
ValueFigures measureValues(const ValueRow& row, std::span<const glm::dvec4> texels,
                           std::span<const glm::vec4> answers);

// A figure that no input stands behind is a breach, and so is an answer that is not finite.
Verdict judgeValues(const ValueRow& row, const ValueFigures& figures);

// The device's answers, by our formulas or by the textbook's.
std::vector<glm::vec4> runValues(const KernelDevice& device, const ValueRow& row,
                                 std::span<const glm::dvec4> texels, bool textbook);

// Both formulas on the first `count` inputs.
ValueOutcome checkValues(const KernelDevice& device, const ValueRow& row, std::uint64_t seed,
                         std::size_t count);

// "rel 8.1e-07, R + T - 1 1.2e-07".
std::string figureText(const ValueRow& row, const ValueFigures& figures);

} // namespace dioptre
