#include "stability/value_run.h"

#include "base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

bool isFinite(std::span<const glm::vec4> answer)
{
    return std::ranges::all_of(answer, [](const glm::vec4& part) {
        return std::isfinite(part.x) && std::isfinite(part.y) && std::isfinite(part.z) &&
               std::isfinite(part.w);
    });
}

ValueFigure figureOf(const ValueGate& gate, std::span<const ValueErrors> errors)
{
    std::size_t judged = 0;
    double largest = 0.0, sum = 0.0, squares = 0.0, others = 0.0;
    for (const ValueErrors& error : errors) {
        const double value = error[gate.error];
        if (std::isnan(value))
            continue;
        ++judged;
        largest = std::max(largest, value);
        sum += value;
        squares += value * value;
        others += gate.of == ValueGate::Of::slope ? error[gate.error + 1] : 0.0;
    }
    if (judged == 0)
        return {};
    switch (gate.of) {
    case ValueGate::Of::rootMeanSquare:
        return {std::sqrt(squares / static_cast<double>(judged)), judged};
    case ValueGate::Of::perMillion:
        return {1e6 * sum / static_cast<double>(errors.size()), judged};
    case ValueGate::Of::slope:
        return {std::abs(sum / others - 1.0), judged};
    case ValueGate::Of::largest:
        break;
    }
    return {largest, judged};
}

} // namespace

ValueFigures measureValues(const ValueRow& row, std::span<const glm::dvec4> texels,
                           std::span<const glm::vec4> answers)
{
    constexpr std::size_t batch = 256; // some milliseconds of work
    const auto parts = static_cast<std::size_t>(row.parts);
    ValueFigures result;
    result.rows = texels.size() / row.texels;
    std::vector<ValueErrors> errors(result.rows, {notJudged, notJudged, notJudged});
    inParallel((result.rows + batch - 1) / batch, [&](std::size_t i) {
        for (std::size_t j = i * batch; j < std::min((i + 1) * batch, result.rows); ++j) {
            const auto answer = answers.subspan(j * parts, parts);
            if (isFinite(answer))
                errors[j] = row.measure(texels.subspan(j * row.texels, row.texels), answer);
        }
    });
    for (std::size_t j = 0; j < result.rows; ++j)
        result.nonFinite += isFinite(answers.subspan(j * parts, parts)) ? 0 : 1;
    for (const ValueGate& gate : row.gates)
        result.figures.push_back(figureOf(gate, errors));
    return result;
}

Verdict judgeValues(const ValueRow& row, const ValueFigures& figures)
{
    std::string breaches;
    const auto add = [&](const std::string& breach) { breaches += (breaches.empty() ? "" : "; ") + breach; };
    if (figures.nonFinite > 0)
        add(fmt::format("{} answers hold a NaN or an infinity", figures.nonFinite));
    for (std::size_t i = 0; i < row.gates.size(); ++i) {
        const ValueGate& gate = row.gates[i];
        const ValueFigure& figure = figures.figures[i];
        if (figure.judged == 0)
            add(fmt::format("{} rests on no answer", gate.what));
        else if (!(figure.value <= gate.most))
            add(fmt::format("{} {:.3g} exceeds {:g}", gate.what, figure.value, gate.most));
    }
    return {breaches.empty(), breaches};
}

std::vector<glm::vec4> runValues(const KernelDevice& device, const ValueRow& row,
                                 std::span<const glm::dvec4> texels, bool textbook)
{
    std::set<std::string> features(row.features.begin(), row.features.end());
    if (textbook)
        features.insert("HAS_TEXTBOOK");
    const DeviceTable table{row.texels, {texels.begin(), texels.end()}};
    return runTable(device.glslFolder, std::string(row.shader), features, device.guard, table, row.parts);
}

ValueOutcome checkValues(const KernelDevice& device, const ValueRow& row, std::uint64_t seed,
                         std::size_t count)
{
    const std::vector<glm::dvec4> texels = inputsOf(row, seed, count);
    ValueOutcome outcome;
    outcome.row = &row;
    outcome.ours = measureValues(row, texels, runValues(device, row, texels, false));
    outcome.verdict = judgeValues(row, outcome.ours);
    outcome.textbook = measureValues(row, texels, runValues(device, row, texels, true));
    outcome.textbookVerdict = judgeValues(row, outcome.textbook);
    return outcome;
}

std::string figureText(const ValueRow& row, const ValueFigures& figures)
{
    std::string text;
    for (std::size_t i = 0; i < row.gates.size(); ++i) {
        const ValueFigure& figure = figures.figures[i];
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", row.gates[i].what,
                            figure.judged > 0 ? fmt::format("{:.2g}", figure.value) : "-");
    }
    return text;
}

} // namespace dioptre
