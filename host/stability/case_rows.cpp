#include "stability/case_rows.h"

#include "base/error.h"
#include "base/interruption.h"
#include "base/parallel.h"
#include "stability/random_floats.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

std::vector<CaseRow> gathered()
{
    std::vector<CaseRow> rows;
    for (const auto& topic : {sphereCases(), cylinderCases(), flatCases(), surfaceCases()})
        rows.insert(rows.end(), topic.begin(), topic.end());
    return rows;
}

std::string limit(std::string_view what, double most, std::string_view none)
{
    return most == 0.0 ? std::string(none) : fmt::format("{} <= {:g}", what, most);
}

} // namespace

std::span<const CaseRow> caseRows()
{
    static const std::vector<CaseRow> rows = gathered();
    return rows;
}

const CaseRow& caseRow(std::string_view name)
{
    const auto rows = caseRows();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const CaseRow& row) { return row.name == name; });
    if (found != rows.end())
        return *found;
    std::string names;
    for (const CaseRow& row : rows)
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    fail(ExitCode::usage, fmt::format("no stability case is called \"{}\"", name), "it is one of " + names);
}

std::vector<RayProblem> problemsOf(std::string_view caseName, std::uint64_t seed, std::size_t count)
{
    const CaseRow& row = caseRow(caseName);
    RandomFloats random(seedOf(row.name, seed));
    std::vector<RayProblem> problems;
    problems.reserve(count + row.group);
    while (problems.size() < count)
        row.append(random, problems);
    for (std::size_t i = 0; i < problems.size(); ++i) {
        problems[i].caseName = row.name;
        problems[i].id =
            row.group == 1 ? std::to_string(i) : fmt::format("{}/{}", i / row.group, i % row.group);
    }
    return problems;
}

std::vector<RayAnswer> answersOf(std::span<const RayProblem> problems)
{
    constexpr std::size_t batch = 512; // some milliseconds of work
    std::vector<RayAnswer> answers(problems.size());
    inParallel((problems.size() + batch - 1) / batch, [&](std::size_t i) {
        Interruption::check();
        const std::size_t end = std::min((i + 1) * batch, problems.size());
        for (std::size_t j = i * batch; j < end; ++j)
            answers[j] = solve(problems[j]);
    });
    return answers;
}

std::string gateText(const Gate& gate)
{
    std::vector<std::string> parts;
    if (gate.k)
        parts.push_back(limit("K", *gate.k, "K = 0"));
    if (gate.relativeT)
        parts.push_back(limit("relative t", *gate.relativeT, "t exact"));
    if (gate.relativeT_p999)
        parts.push_back(limit("relative t at p99.9", *gate.relativeT_p999, "t exact at p99.9"));
    if (gate.normal_rad)
        parts.push_back(limit("normal", *gate.normal_rad, "normal exact") +
                        (*gate.normal_rad == 0.0 ? "" : " rad"));
    if (gate.flips)
        parts.push_back(limit("flips per million", *gate.flips, "no flips"));
    if (gate.flipsOverMargin)
        parts.push_back(
            limit("flips over margin per million", *gate.flipsOverMargin, "no flips over margin"));
    if (gate.leaks)
        parts.push_back(limit("leaks per million", *gate.leaks, "no leaks"));
    return fmt::format("{}", fmt::join(parts, ", "));
}

} // namespace dioptre
