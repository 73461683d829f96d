#include "command/stability.h"

#include "base/interruption.h"
#include "base/text.h"
#include "command/stability_batch.h"
#include "command/stability_device.h"
#include "command/stability_report.h"
#include "command/stability_scales.h"
#include "gl/context.h"
#include "stability/kernel_run.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// The rows that were asked for, in the order of the table.
struct AskedRows {
    std::vector<const CaseRow*> cases;
    std::vector<const ValueRow*> values;
};

AskedRows rowsOf(const StabilityOptions& options)
{
    std::vector<std::string> known;
    const auto isAsked = [&](std::string_view name) {
        known.emplace_back(name);
        return options.cases.empty() || std::ranges::find(options.cases, name) != options.cases.end();
    };
    AskedRows rows;
    for (const CaseRow& row : caseRows())
        if (isAsked(row.name))
            rows.cases.push_back(&row);
    for (const ValueRow& row : valueRows())
        if (isAsked(row.name))
            rows.values.push_back(&row);
    for (const auto& name : options.cases)
        if (std::ranges::find(known, name) == known.end())
            fail(ExitCode::usage, fmt::format("no stability case is called \"{}\"", name),
                 "it is one of " + join(known, ", "));
    return rows;
}

StabilityResult run(const KernelDevice& device, const CaseRow& row, const StabilityOptions& options)
{
    const auto problems = problemsOf(row.name, options.seed, static_cast<std::size_t>(options.rays));
    const auto truth = answersOf(problems);
    const auto figures = [&](std::optional<Variant> variant) {
        return measureCase(row, problems, truth, runKernels(device, problems, variant, Frame::given));
    };
    StabilityResult result{&row, figures(std::nullopt), {}, figures(Variant::textbook), {}};
    result.verdict = judgeCase(row, result.figures);
    result.textbookVerdict = judgeCase(row, result.textbook);
    return result;
}

// Of a full run's inputs the share that --rays is of a full run's rays, but enough for shares of a few per
// cent.
std::size_t inputsOf(const ValueRow& row, const StabilityOptions& options)
{
    constexpr double fullRun = 200000.0;
    constexpr double least = 2000.0;
    const double all = static_cast<double>(row.count);
    return static_cast<std::size_t>(std::min(all, std::max(least, all * options.rays / fullRun)));
}

} // namespace

ExitCode stability(const StabilityOptions& options)
{
    const AskedRows rows = rowsOf(options); // a wrong name is told before anything runs
    if (!options.input.empty())
        return runBatch(options);
    const auto context = makeContext(options.backend);
    const KernelDevice device = kernelDeviceHere();
    StabilityTable table;
    for (const CaseRow* row : rows.cases) {
        Interruption::check();
        table.cases.push_back(run(device, *row, options));
        if (!options.json)
            printRow(table.cases.back(), table.cases.size() == 1);
    }
    for (const ValueRow* row : rows.values) {
        Interruption::check();
        table.values.push_back(checkValues(device, *row, options.seed, inputsOf(*row, options)));
        if (!options.json)
            printRow(table.values.back(), table.values.size() == 1);
    }
    if (!options.plot.empty())
        writeScalePlot(device, options);
    report(options, context->info(), table);
    return table.failures() == 0 ? ExitCode::done : ExitCode::checkFailed;
}

} // namespace dioptre
